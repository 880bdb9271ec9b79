//! Expressions of time, compiled to a program for a stack machine.

use super::jet::Jet;

/// Values that may wait on the stack; the scene's compiler has the same bound.
const STACK: usize = 64;

/// Functions of one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unary {
    Negate,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Exp,
    Log,
    Log10,
    Sqrt,
    Abs,
    Floor,
    Ceil,
    Round,
    Sinh,
    Cosh,
    Tanh,
}

/// Functions of two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Atan2,
    Min,
    Max,
    Hypot,
}

/// One instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Op {
    Push(f64),
    Time,
    Unary(Unary),
    Binary(Binary),
}

impl Op {
    /// From its number at the border; the scene's compiler has the same table.
    fn decode(code: f64, operand: f64) -> Option<Self> {
        #[allow(clippy::cast_possible_truncation)]
        let number = code as i32;
        if f64::from(number) != code {
            return None;
        }
        Some(match number {
            0 => Self::Push(operand),
            1 => Self::Time,
            2 => Self::Binary(Binary::Add),
            3 => Self::Binary(Binary::Subtract),
            4 => Self::Binary(Binary::Multiply),
            5 => Self::Binary(Binary::Divide),
            6 => Self::Binary(Binary::Power),
            7 => Self::Unary(Unary::Negate),
            20 => Self::Unary(Unary::Sin),
            21 => Self::Unary(Unary::Cos),
            22 => Self::Unary(Unary::Tan),
            23 => Self::Unary(Unary::Asin),
            24 => Self::Unary(Unary::Acos),
            25 => Self::Unary(Unary::Atan),
            26 => Self::Binary(Binary::Atan2),
            27 => Self::Unary(Unary::Exp),
            28 => Self::Unary(Unary::Log),
            29 => Self::Unary(Unary::Log10),
            30 => Self::Unary(Unary::Sqrt),
            31 => Self::Unary(Unary::Abs),
            32 => Self::Unary(Unary::Floor),
            33 => Self::Unary(Unary::Ceil),
            34 => Self::Binary(Binary::Min),
            35 => Self::Binary(Binary::Max),
            38 => Self::Binary(Binary::Hypot),
            39 => Self::Unary(Unary::Sinh),
            40 => Self::Unary(Unary::Cosh),
            41 => Self::Unary(Unary::Tanh),
            42 => Self::Unary(Unary::Round),
            _ => return None,
        })
    }

    /// Values taken from the stack; every instruction puts one back.
    fn takes(self) -> usize {
        match self {
            Self::Push(_) | Self::Time => 0,
            Self::Unary(_) => 1,
            Self::Binary(_) => 2,
        }
    }
}

/// A checked program: it never runs out of values, never overflows the stack, and leaves one value.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    ops: Vec<Op>,
}

impl Program {
    /// From pairs (number of the instruction, operand) in postfix order.
    ///
    /// # Errors
    /// A message when the pairs are no program.
    pub fn new(pairs: &[f64]) -> Result<Self, String> {
        if pairs.len() % 2 != 0 {
            return Err("an expression needs pairs of instruction and operand".into());
        }
        let ops = pairs
            .chunks_exact(2)
            .map(|p| Op::decode(p[0], p[1]).ok_or(format!("unknown instruction {}", p[0])))
            .collect::<Result<Vec<_>, _>>()?;
        check(&ops)?;
        Ok(Self { ops })
    }

    /// Value, rate of change and its rate at the time `t` [s].
    #[must_use]
    pub fn derivatives(&self, t: f64) -> [f64; 3] {
        let mut stack = [Jet::default(); STACK];
        let mut top = 0;
        for op in &self.ops {
            top -= op.takes();
            stack[top] = match *op {
                Op::Push(value) => Jet::constant(value),
                Op::Time => Jet::time(t),
                Op::Unary(function) => stack[top].unary(function),
                Op::Binary(function) => stack[top].binary(stack[top + 1], function),
            };
            top += 1;
        }
        [stack[0].value, stack[0].rate, stack[0].curvature]
    }
}

fn check(ops: &[Op]) -> Result<(), String> {
    let mut depth = 0_usize;
    for op in ops {
        let Some(left) = depth.checked_sub(op.takes()) else {
            return Err("an expression takes a value that is not there".into());
        };
        depth = left + 1;
        if depth > STACK {
            return Err(format!(
                "an expression holds more than {STACK} values at once"
            ));
        }
    }
    if depth == 1 {
        Ok(())
    } else {
        Err(format!("an expression leaves {depth} values instead of 1"))
    }
}
