//! What a demonstration says at its end.

use drivewright_codegen::emit::escape;
use serde_json::{Map, Value, json};

use super::{Played, Scene};
use crate::End;
use crate::output::{Shape, print, tell};
use crate::trace;

/// Prints the play; what failed is told.
pub(super) fn tell(played: &Played, shape: Shape) -> End {
    let end = match &played.failed {
        Some(why) => {
            tell!("error: {}", escape::visible(why));
            End::Findings
        }
        None => End::Fine,
    };
    let printed = match shape {
        Shape { json: true, .. } => print(&as_json(played)),
        Shape { quiet: true, .. } => End::Fine,
        _ => print(&as_text(played)),
    };
    end.max(printed)
}

fn as_text(played: &Played) -> String {
    let mut out = format!(
        "{}: simulated from its profile, without hardware\n\n{}\n",
        escape::visible(&played.title),
        trace::text(&played.trace)
    );
    if !played.fault.is_empty() {
        out.extend([&escape::visible(&played.fault), "\n\n"]);
    }
    let width = played.scenes.iter().map(|scene| scene.title.chars().count()).max().unwrap_or(0);
    out.extend(played.scenes.iter().map(|scene| {
        let (from, to) = scene.span;
        let took = format!("{} ms", (to - from) / 1000);
        format!("{:<width$}  {took:>8}  {}\n", scene.title, escape::visible(&scene.told))
    }));
    out
}

/// Lines of the trace, and an object for all of it.
fn as_json(played: &Played) -> String {
    let scenes: Vec<Value> = played.scenes.iter().map(scene).collect();
    let whole = json!({
        "drive": played.title,
        "scenes": scenes,
        "fault": played.fault,
        "failed": played.failed,
    });
    format!("{}{}\n", trace::json_lines(&played.trace), escape::json(&whole.to_string()))
}

fn scene(scene: &Scene) -> Value {
    let mut object = Map::new();
    object.insert("scene".into(), json!(scene.title));
    object.insert("from_us".into(), json!(scene.span.0));
    object.insert("to_us".into(), json!(scene.span.1));
    object.insert("told".into(), json!(scene.told));
    object.extend(scene.numbers.iter().map(|(name, number)| ((*name).to_owned(), json!(number))));
    Value::Object(object)
}
