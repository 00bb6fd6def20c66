// The form: builds its fields once, shows the case file in them, and reports what they change.

import { File, groups } from "./fields.js";

export class Form {
  /** `change(changes)` gets pairs of key path and value. */
  constructor(element, database, change) {
    this.change = change;
    this.keys = database.keys;
    this.file = null;
    this.groups = groups(database).map((group, i) => this.#group(element, group, i));
  }

  #group(form, group, i) {
    const set = document.createElement("fieldset");
    const legend = document.createElement("legend");
    legend.textContent = group.legend;
    const note = Object.assign(document.createElement("p"), { className: "hint", hidden: true });
    const error = Object.assign(document.createElement("p"), { className: "group-error", hidden: true, id: `group-error-${i}` });
    set.append(legend, note);
    const fields = group.fields.map((field, k) => this.#field(set, field, `field-${i}-${k}`));
    set.append(error);
    set.setAttribute("aria-describedby", error.id);
    form.append(set);
    return { ...group, set, noteElement: note, error, fields };
  }

  #field(set, field, id) {
    const box = Object.assign(document.createElement("div"), { className: field.wide ? "field wide" : "field" });
    const label = Object.assign(document.createElement("label"), { htmlFor: id, textContent: field.label });
    const input = document.createElement(field.options ? "select" : "input");
    input.id = id;
    if (!field.options) input.type = field.checkbox ? "checkbox" : "text";
    const hint = Object.assign(document.createElement("p"), { className: "hint", id: `${id}-hint`, textContent: field.hint ?? "" });
    hint.hidden = !field.hint;
    const error = Object.assign(document.createElement("p"), { className: "error", id: `${id}-error`, hidden: true });
    input.setAttribute("aria-describedby", `${hint.id} ${error.id}`);
    if (field.checkbox) {
      const line = Object.assign(document.createElement("div"), { className: "check" });
      line.append(input, label);
      box.append(line, hint, error);
    } else {
      box.append(label, input, hint, error);
    }
    set.append(box);
    const built = { ...field, box, input, error, hintElement: hint };
    input.addEventListener(field.options || field.checkbox ? "change" : "input", () => this.#changed(built));
    return built;
  }

  #changed(field) {
    if (!this.file) return;
    const { input } = field;
    if (field.choose) {
      this.change(field.choose(this.file, field.checkbox ? input.checked : input.value));
      return;
    }
    const key = field.keys(this.file);
    const text = input.value.trim();
    const isNumber = this.keys[key]?.number && text !== "" && Number.isFinite(Number(text));
    this.change([[key, text === "" ? null : isNumber ? Number(text) : input.value]]);
  }

  #value(field) {
    if (field.value) return field.value(this.file);
    return this.file.value(field.keys(this.file));
  }

  /** Shows a case file as the module reads it, and the error of its check. */
  show(read, checked) {
    const valid = read.ok;
    if (valid) this.file = new File(read);
    for (const group of this.groups) {
      group.set.disabled = !valid;
      group.error.hidden = true;
      if (!this.file) continue;
      const note = group.note?.(this.file) ?? "";
      group.noteElement.textContent = note;
      group.noteElement.hidden = !note;
      const byLabel = (label) => this.#value(group.fields.find((field) => field.label === label));
      for (const field of group.fields) {
        this.#show(field, field.shown?.(this.file, byLabel) ?? true);
      }
    }
    if (!checked.ok && valid) this.#showError(checked.error);
  }

  #show(field, shown) {
    const { input, box, error } = field;
    box.hidden = !shown;
    error.hidden = true;
    input.removeAttribute("aria-invalid");
    if (!shown) return;
    const key = field.keys(this.file);
    box.dataset.key = key;
    input.title = this.keys[key]?.words ?? "";
    const value = this.#value(field);
    // A table or a list where the form has one value: of a quantity with an uncertainty, of a law.
    const beyond = !field.value && value === undefined && this.file.tables.includes(key);
    input.disabled = beyond;
    if (beyond) {
      field.hintElement.textContent = "given in the case file";
      field.hintElement.hidden = false;
    } else {
      field.hintElement.textContent = field.hint ?? "";
      field.hintElement.hidden = !field.hint;
    }
    if (field.checkbox) {
      input.checked = value;
      return;
    }
    if (field.options) this.#fill(field, String(value ?? ""));
    const text = beyond ? "" : String(value ?? "");
    // The user's text stays as typed where it means the same.
    if (document.activeElement === input && !field.options && (input.value.trim() === text || (this.keys[key]?.number && input.value.trim() !== "" && Number(input.value) === value))) return;
    input.value = text;
  }

  /** The choices of a field; one that the form does not know is added as it stands in the file. */
  #fill(field, value) {
    const options = field.options(this.file);
    if (!options.some(([name]) => name === value)) options.push([value, value === "" ? "(none)" : `${value} (as in the case file)`]);
    const signature = JSON.stringify(options);
    if (field.signature === signature) return;
    field.signature = signature;
    field.input.replaceChildren(...options.map(([name, title]) => new Option(title, name)));
  }

  /** The program's message at the field of its key; at the group, where no field has it. */
  #showError(error) {
    const text = [error.message ?? error.text, ...(error.help ?? [])].join("\n");
    const key = error.key ?? "";
    const all = this.groups.flatMap((group) => group.fields).filter((field) => !field.box.hidden);
    const keys = (field) => [field.keys(this.file), ...(field.also?.(this.file) ?? [])];
    const field = key && (all.find((one) => one.keys(this.file) === key) ?? all.find((one) => keys(one).includes(key)));
    if (field) {
      field.error.textContent = text;
      field.error.hidden = false;
      field.input.setAttribute("aria-invalid", "true");
      return;
    }
    const section = key.split(".")[0];
    const group = this.groups.find((one) => one.sections.includes(section));
    if (group) {
      group.error.textContent = text;
      group.error.hidden = false;
    }
  }
}
