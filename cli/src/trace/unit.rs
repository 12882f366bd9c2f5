//! Counts of an object as a number with a unit.

use drivewright_runtime::address::Address;
use drivewright_runtime::model::DriveModel;
use drivewright_runtime::quantity::QuantityKind;

/// A unit: one count is `num / den` of `symbol`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Unit {
    pub(crate) symbol: String,
    num: i128,
    /// Not 0.
    den: i128,
}

/// The most decimals that a count is shown with.
const DECIMALS: u32 = 3;

impl Unit {
    /// A count is worth one, of something without a name.
    pub(crate) fn counts() -> Self {
        Self { symbol: "counts".to_owned(), num: 1, den: 1 }
    }

    /// One count is `num / den` of `symbol`; a `den` of 0 is taken as 1.
    pub(crate) fn new(symbol: &str, num: u32, den: u32) -> Self {
        Self { symbol: symbol.to_owned(), num: num.into(), den: den.max(1).into() }
    }

    /// The unit of an entry of a drive. Shares of rated torque are shown in percent.
    pub(crate) fn of(model: &DriveModel<'_>, at: Address) -> Self {
        let Some(unit) = model.object(at).and_then(|object| model.unit_of(object)) else {
            return Self::counts();
        };
        let (num, den) = unit.factor();
        match unit.quantity() {
            QuantityKind::TorqueRatio | QuantityKind::CurrentRatio => {
                Self { num: i128::from(num) * 100, ..Self::new("%", num, den) }
            }
            quantity if quantity.symbol().is_empty() => Self::new(unit.text(), 1, 1),
            quantity => Self::new(quantity.symbol(), num, den),
        }
    }

    /// So many decimals as tell every count from the next, three at most.
    fn decimals(&self) -> u32 {
        (0..DECIMALS).find(|n| self.num * 10_i128.pow(*n) % self.den == 0).unwrap_or(DECIMALS)
    }

    /// A number of counts as a decimal number, rounded to the nearest: exact where three decimals can say it.
    pub(crate) fn show(&self, raw: i64) -> String {
        let one = 10_i128.pow(self.decimals());
        let scaled = i128::from(raw) * self.num * one;
        let half = if scaled < 0 { -self.den / 2 } else { self.den / 2 };
        let rounded = (scaled + half) / self.den;
        let sign = if rounded < 0 { "-" } else { "" };
        let (whole, part) = (rounded.abs() / one, rounded.abs() % one);
        match self.decimals() as usize {
            0 => format!("{sign}{whole}"),
            width => format!("{sign}{whole}.{part:0width$}"),
        }
    }

    /// As [`show`](Self::show), with the symbol.
    pub(crate) fn told(&self, raw: i64) -> String {
        format!("{} {}", self.show(raw), self.symbol)
    }

    /// For a plot.
    #[allow(clippy::cast_precision_loss, reason = "a plot is a picture")]
    pub(crate) fn value(&self, raw: i64) -> f64 {
        raw as f64 * self.num as f64 / self.den as f64
    }
}
