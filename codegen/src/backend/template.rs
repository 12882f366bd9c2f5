//! Texts from templates. What a template names and nobody gives is an error that shows in the text.

use minijinja::{Environment, UndefinedBehavior};
use serde::Serialize;

/// Renders one template. Nothing is escaped: what a context holds is escaped for the language of the template.
pub(super) fn render(template: &str, context: &impl Serialize) -> String {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    let rendered = environment.render_str(template, minijinja::value::Serde(context));
    // The templates are part of this crate and tested; what is wrong with one shows in the file.
    rendered.map_or_else(|error| format!("{error}\n"), |text| text.trim_end().to_owned() + "\n")
}
