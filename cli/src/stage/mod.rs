//! A virtual drive of a profile's folder, looked at while it runs: what `simulate` and `demo` share.

mod bus;
pub(crate) mod image;
mod record;

use std::path::PathBuf;

use clap::Args;
use drivewright_codegen::live::{self, Arena, Live};
use drivewright_codegen::sink;
use drivewright_runtime::sim::{ASSUMPTIONS, Config, VirtualDrive, cells};

use crate::End;
use crate::drives::Found;
use crate::output::{disk, tell};
use crate::trace::{self, Trace};

pub(crate) use bus::Watched;
pub(crate) use record::{POSITION, Pace, Recorder, SPEED, TORQUE, force, named};

/// Files that a trace goes to.
#[derive(Args)]
pub(crate) struct TraceFiles {
    /// Draw position, speed, torque, state, mode and status bits over time, as SVG.
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// Write every sample, as CSV.
    #[arg(long, value_name = "FILE")]
    pub(crate) csv: Option<PathBuf>,
}

impl TraceFiles {
    /// Writes those that are asked for.
    pub(crate) fn write(&self, trace: &Trace) -> End {
        let plot = self.plot.iter().map(|place| (place, trace::svg(trace)));
        let csv = self.csv.iter().map(|place| (place, trace::csv(trace)));
        let write = |(place, text): (&PathBuf, String)| match sink::write_file(place, text.as_bytes()) {
            Ok(()) => End::Fine,
            Err(error) => disk(&error),
        };
        plot.chain(csv).map(write).max().unwrap_or(End::Fine)
    }
}

/// Makes a virtual drive of a profile and gives it to `run`.
pub(crate) fn with<T>(
    found: &Found,
    config: Config,
    run: impl FnOnce(&Live<'_>, &mut VirtualDrive<'_, '_>) -> T,
) -> Result<T, End> {
    let Some(profile) = found.compiled.sound() else { return Err(End::Findings) };
    let arena = Arena::default();
    let live = live::tables(profile, &arena);
    let model = live.model();
    let mut memory = vec![0; cells(model)];
    match VirtualDrive::new(model, &mut memory, config) {
        Ok(mut drive) => Ok(run(&live, &mut drive)),
        Err(error) => {
            tell!("error: no virtual drive can be made of {}: {error}", found.id);
            Err(End::Findings)
        }
    }
}

/// `SAVCH SDV3-E, virtual`
pub(crate) fn title(found: &Found) -> String {
    let drive = found.compiled.model.as_ref().map(|model| &model.drive);
    drive.map_or_else(|| found.id.clone(), |drive| format!("{} {}, virtual", drive.vendor, drive.name))
}

/// What the virtual drive does and no manual says, a line each.
pub(crate) fn assumptions() -> String {
    let line = |one: &drivewright_runtime::sim::Assumption| {
        format!("  {}: {} ({})\n", one.about, one.is, one.because)
    };
    ASSUMPTIONS.iter().map(line).collect()
}
