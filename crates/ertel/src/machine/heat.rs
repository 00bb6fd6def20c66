//! Heat balance of a bearing: its contacts are solved at the temperature that results from their friction.
//!
//! ```text
//!   T = T_ambient + R P(T)
//! ```
//! by the secant method on T_ambient + R P(T) − T. P falls with T, so the first step is half of the residual.

use ertel_input::InputError;

use super::figures;
use crate::case::{Case, MachineContacts, Mechanics};
use crate::figures::bearing::BEARING_TEMPERATURE;
use crate::mark::Marked;
use crate::point::MachineSolution;
use crate::words::CELSIUS;

/// Largest difference between the temperature from the heat of the contacts and that of the lubricant, K.
const TOLERANCE: f64 = 0.1;
/// Largest number of rounds.
const ROUNDS: usize = 8;
/// Largest step, K.
const STEP: f64 = 40.0;

/// A machine that was solved, with the case at whose temperature it was.
#[derive(Clone, Debug)]
pub struct SolvedMachine {
    /// The case of the last round; that of the machine without a heat balance.
    pub case: Case,
    /// The contacts.
    pub solution: MachineSolution,
    /// Result of the balance; `None` where the case does not request one, or where contacts failed or were not solved.
    pub balance: Option<Balance>,
}

/// A heat balance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// Temperature of the lubricant in the last round, K.
    pub temperature: f64,
    /// Temperature from the heat of the contacts minus that of the lubricant, K.
    pub rest: f64,
    /// Rounds, each with all contacts.
    pub rounds: usize,
    /// Whether the heat of the last round is not to be used.
    pub is_doubtful: bool,
}

impl Balance {
    /// Whether it was found.
    pub fn is_found(&self) -> bool {
        self.rest.abs() < TOLERANCE && !self.is_doubtful
    }

    /// Reason why it was not found.
    pub fn words(&self) -> String {
        if self.is_doubtful {
            return format!(
                "no heat balance: with the lubricant at {:.1} °C the friction of the contacts is not to be used",
                self.temperature - CELSIUS
            );
        }
        format!(
            "no heat balance in {} rounds: with the lubricant at {:.1} °C the contacts heat it to {:.1} °C",
            self.rounds,
            self.temperature - CELSIUS,
            self.temperature + self.rest - CELSIUS
        )
    }
}

/// Solves the contacts of a machine, at the temperature of its heat balance where the case requests it; `None` for a case that is
/// no machine. `solve_contacts` solves them at one temperature.
///
/// # Errors
/// Laws of the lubricant that do not reach a temperature on the way.
pub(crate) fn solve_by(
    case: &Case,
    mut solve_contacts: impl FnMut(&MachineContacts) -> MachineSolution,
) -> Result<Option<SolvedMachine>, InputError> {
    let Some(contacts) = &case.contacts else {
        return Ok(None);
    };
    let mut solved = SolvedMachine {
        case: case.clone(),
        solution: solve_contacts(contacts),
        balance: None,
    };
    if !asks_for_balance(&solved.solution) {
        return Ok(Some(solved));
    }
    let mut before: Option<[f64; 2]> = None;
    for rounds in 1..=ROUNDS {
        let Some(aim) = temperature(&solved) else {
            return Ok(Some(solved));
        };
        let own = solved.case.lubricant.temperature;
        let balance = Balance {
            temperature: own,
            rest: aim.value - own,
            rounds,
            is_doubtful: aim.is_doubtful(),
        };
        solved.balance = Some(balance);
        if balance.is_found() || balance.is_doubtful || rounds == ROUNDS {
            break;
        }
        let next = own + step(before, [own, balance.rest]);
        before = Some([own, balance.rest]);
        let case = solved.case.at_temperature(next)?;
        let Some(contacts) = case.contacts.clone() else {
            break;
        };
        solved.solution = solve_contacts(&contacts);
        solved.case = case;
    }
    report_balance(&mut solved);
    Ok(Some(solved))
}

/// Whether the case asks for a balance.
fn asks_for_balance(solution: &MachineSolution) -> bool {
    let mechanics = &solution.machine.mechanics;
    matches!(mechanics, Mechanics::Bearing(bearing) if bearing.life.heat_balance)
}

/// The temperature from the heat of all contacts, K.
fn temperature(solved: &SolvedMachine) -> Option<Marked> {
    let figures = figures(&solved.case, &solved.solution);
    Some(figures.find(BEARING_TEMPERATURE.name)?.estimate)
}

/// The next step, K, from the points (temperature, rest) before and now: half of the residual at first, then by the secant, which must fall.
fn step(before: Option<[f64; 2]>, [own, rest]: [f64; 2]) -> f64 {
    let slope = before.map(|[at, was]| (rest - was) / (own - at));
    let step = match slope {
        Some(slope) if slope < -0.2 => -rest / slope,
        _ => 0.5 * rest,
    };
    step.clamp(-STEP, STEP)
}

/// Adds the balance to the rows of the machine.
fn report_balance(solved: &mut SolvedMachine) {
    let (Some(balance), Some(machine)) = (solved.balance, &mut solved.case.machine) else {
        return;
    };
    let rest = format!("{:.2} K", balance.rest);
    let text = match balance.is_found() {
        true => format!(
            "at {:.1} °C after {} rounds, within {rest}",
            balance.temperature - CELSIUS,
            balance.rounds
        ),
        false if balance.is_doubtful => balance.words(),
        false => format!(
            "not found in {} rounds: with the lubricant at {:.1} °C in the last one, the heat of the contacts gave a temperature {:+.2} K from that",
            balance.rounds,
            balance.temperature - CELSIUS,
            balance.rest
        ),
    };
    machine.rows.push(("heat balance".to_owned(), text));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A power of 60 W that halves with every 20 K, 1 K/W: the root of x = 60 · 2^(−x/20) by halving an interval.
    #[test]
    fn secant() {
        let rest = |x: f64| 60.0 * (-x / 20.0).exp2() - x;
        let (mut low, mut high) = (0.0, 60.0);
        for _ in 0..60 {
            let middle: f64 = 0.5 * (low + high);
            if rest(middle) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let (mut x, mut before) = (60.0, None);
        let mut rounds = 0;
        while rest(x).abs() >= TOLERANCE {
            let now = [x, rest(x)];
            x += step(before, now);
            before = Some(now);
            rounds += 1;
            assert!(rounds < ROUNDS, "{x}");
        }
        assert!((x - low).abs() < 0.1, "{x} {low}");
    }
}
