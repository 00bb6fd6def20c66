//! Pages of results, as `ertel view` reads them.

use ertel::output::html::{joint_page, page_data, study_page};

use super::{Verdict, check_text};
use crate::finding::Defect;
use crate::input::{Input, Target};

/// Before the data of a page.
const DATA: &str = "<script type=\"application/json\"";

/// Pages without the scripts around their data, which nobody reads: of a study, and of a contact as far as readers look at it.
pub fn seeds() -> Vec<Input> {
    let table = "point,speed_m_per_s,film_central_m\n1,1,1e-7\n2,2,1.6e-7\n";
    let page = study_page("a study", table, 1, vec!["a warning".to_owned()]);
    let data = page.find(DATA).map_or("", |at| &page[at..]);
    let (open, rest) = data.split_once('>').unwrap_or_default();
    let study = rest.split("</script>").next().unwrap_or_default();
    let contact = r#"{"version":1,"results":[{"name":"a","kind":"line","figures":[{"x":1.5,"y":[1,2,null]}]}]}"#;
    let input = |data: &str| Input {
        target: Target::View,
        files: vec![(
            Target::View.main_file().to_owned(),
            format!("<html>{open}>{data}</script></html>").into_bytes(),
        )],
    };
    vec![input(study), input(contact)]
}

/// Reads `report.html` and shows it twice on one page; the page that this makes can be read again.
pub fn run(input: &Input) -> Result<Verdict, Defect> {
    let Ok(page) = std::str::from_utf8(input.file(Target::View.main_file())) else {
        return Ok(Verdict::Refused);
    };
    let data = match page_data(page) {
        Ok(data) => data,
        Err(error) => return check_text(&ertel_input::escaped(&error.to_string())),
    };
    let parts = ["first", "</script>"].map(|name| (name.to_owned(), data.clone()));
    match joint_page(parts.to_vec()) {
        Ok(page) => match page_data(&page) {
            Ok(_) => Ok(Verdict::Taken),
            Err(error) => Err(Defect::wrong("a page that is none", error.to_string())),
        },
        Err(error) => check_text(&ertel_input::escaped(&error.to_string())),
    }
}
