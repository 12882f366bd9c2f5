//! Texts from templates. What a template names and nobody gives is an error that shows in the text.

use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, UndefinedBehavior};
use serde::Serialize;

/// Renders one template. Nothing is escaped: what a context holds is escaped for the language of the template.
pub(super) fn render(template: &str, context: &impl Serialize) -> String {
    rendered(&environment(), template, context)
}

/// Renders a template in which a line with nothing but a block leaves no line behind.
pub(super) fn render_lines(template: &str, context: &impl Serialize) -> String {
    let mut environment = environment();
    environment.set_syntax(
        SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build().unwrap_or_default(),
    );
    rendered(&environment, template, context)
}

fn environment() -> Environment<'static> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment
}

fn rendered(environment: &Environment<'_>, template: &str, context: &impl Serialize) -> String {
    let rendered = environment.render_str(template, minijinja::value::Serde(context));
    // The templates are part of this crate and tested; what is wrong with one shows in the file.
    rendered.map_or_else(|error| format!("{error}\n"), |text| text.trim_end().to_owned() + "\n")
}
