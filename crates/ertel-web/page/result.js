// The result: the program's report, its pictures, and its files to keep.

const PICTURES = {
  centreline: "Pressure and film on the centreline",
  film: "Film thickness over the contact",
  pressure: "Pressure over the contact",
  convergence: "Convergence of Newton’s method",
  temperature: "Temperatures on the centreline",
  "cross-film": "Temperature across the film",
  stress: "Stress after von Mises in the bodies",
  wear: "Wear over the sliding distance",
  interferogram: "Interferogram",
};
const TYPES = { json: "application/json", svg: "image/svg+xml", png: "image/png", html: "text/html", nc: "application/x-netcdf" };

/** Addresses of the last result's files, given back when the next one comes. */
let addresses = [];

function address(file) {
  const type = TYPES[file.name.split(".").pop()] ?? "text/plain";
  const bytes = file.base64 ? Uint8Array.from(atob(file.base64), (c) => c.charCodeAt(0)) : file.text;
  const url = URL.createObjectURL(new Blob([bytes], { type }));
  addresses.push(url);
  return url;
}

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** Fills an element with the answer of a solve. */
export function showResult(place, answer) {
  addresses.forEach((url) => URL.revokeObjectURL(url));
  addresses = [];
  place.replaceChildren();
  if (!answer.ok) {
    place.append(element("pre", { className: "message", tabIndex: 0, textContent: `error: ${answer.error.text}` }));
    return;
  }
  const { files } = answer;
  if (answer.unresolved.length > 0) {
    const text = `Not resolved: ${answer.unresolved.join("; ")}. Raise max_unknowns in [mesh]; the warnings say what the mesh lacks.`;
    place.append(element("p", { className: "unresolved", textContent: text }));
  }
  if (answer.failed_points > 0) {
    place.append(element("p", { className: "unresolved", textContent: `${answer.failed_points} points failed; the report has the reasons.` }));
  }
  const links = files.map((file) => element("li", {}, element("a", { href: address(file), download: file.name, textContent: file.name })));
  place.append(element("ul", { className: "files" }, ...links));
  const page = files.find((file) => file.name === "report.html");
  if (page) {
    // The report is a separate page with a script, which the policy of this page would not let run.
    const frame = element("iframe", { title: "Report", src: "frame.html", allow: "clipboard-write" });
    frame.setAttribute("sandbox", "allow-scripts");
    frame.addEventListener("load", () => frame.contentWindow.postMessage(page.text, "*"), { once: true });
    place.append(frame);
    return;
  }
  const report = files.find((file) => file.name === "report.txt");
  const text = element("pre", { className: "report", tabIndex: 0, textContent: report.text });
  text.setAttribute("role", "region");
  text.setAttribute("aria-label", "Report");
  place.append(text);
  const pictures = files.filter((file) => file.name.endsWith(".svg")).map((file) => {
    const name = file.name.replace(/\.svg$/, "");
    return element("figure", {}, element("img", { src: address(file), alt: PICTURES[name] ?? name }));
  });
  place.append(element("div", { className: "pictures" }, ...pictures));
}
