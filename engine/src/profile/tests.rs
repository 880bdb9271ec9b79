use std::f64::consts::{LN_2, PI, TAU};

use super::*;

fn program(pairs: &[(i32, f64)]) -> Profile {
    let flat: Vec<f64> = pairs
        .iter()
        .flat_map(|&(op, x)| [f64::from(op), x])
        .collect();
    Profile::Expression(Program::new(&flat).unwrap())
}

/// sin(2 pi t) exp(-t)
fn damped_sine() -> Profile {
    program(&[
        (0, TAU),
        (1, 0.0),
        (4, 0.0),
        (20, 0.0),
        (1, 0.0),
        (7, 0.0),
        (27, 0.0),
        (4, 0.0),
    ])
}

fn shared(profile: Profile) -> Option<Arc<Profile>> {
    Some(Arc::new(profile))
}

fn smooth_profiles() -> Vec<Profile> {
    vec![
        Profile::Constant,
        Profile::Sine {
            frequency: 1.7,
            phase: 0.4,
        },
        Profile::Ramp { over: 0.8 },
        Profile::Step { at: 0.33 },
        Profile::Table(Curve::held(&[(0.2, -1.0), (0.5, 2.0), (1.4, 0.5)])),
        damped_sine(),
    ]
}

#[test]
fn values_follow_their_formulas() {
    let sine = Profile::Sine {
        frequency: 2.0,
        phase: 0.5,
    };
    assert!((sine.value(0.3) - (TAU * 0.6 + 0.5).sin()).abs() < 1e-15);
    let ramp = Profile::Ramp { over: 4.0 };
    assert_eq!(
        [-1.0, 0.0, 1.0, 4.0, 9.0].map(|t| ramp.value(t)),
        [0.0, 0.0, 0.25, 1.0, 1.0]
    );
    let step = Profile::Step { at: 1.0 };
    assert_eq!([0.999, 1.0].map(|t| step.value(t)), [0.0, 1.0]);
    let t = 0.7_f64;
    assert!((damped_sine().value(t) - (TAU * t).sin() * (-t).exp()).abs() < 1e-15);
}

/// How far rate and curvature are from central differences of value and rate.
fn rate_errors(profile: &Profile, t: f64, h: f64) -> [f64; 2] {
    let [before, now, after] = [t - h, t, t + h].map(|t| profile.derivatives(t));
    [0, 1].map(|k| (now[k + 1] - (after[k] - before[k]) / (2.0 * h)).abs())
}

#[test]
fn rates_agree_with_differences() {
    let h = 1e-6;
    for profile in smooth_profiles() {
        for t in [0.05, 0.3, 0.45, 0.77, 1.3, 2.0] {
            let error = rate_errors(&profile, t, h);
            assert!(error[0] < 1e-7, "{profile:?} {t} {error:?}"); // measured 6e-10
            assert!(error[1] < 1e-6, "{profile:?} {t} {error:?}"); // measured 1.6e-8
        }
    }
}

/// Every instruction at t = 0.6: value against std, rates against differences.
#[test]
fn every_instruction_computes_what_its_name_says() {
    let t = 0.6_f64;
    let unary: [(i32, f64); 18] = [
        (7, -t),
        (20, t.sin()),
        (21, t.cos()),
        (22, t.tan()),
        (23, t.asin()),
        (24, t.acos()),
        (25, t.atan()),
        (27, t.exp()),
        (28, t.ln()),
        (29, t.log10()),
        (30, t.sqrt()),
        (31, t),
        (32, 0.0),
        (33, 1.0),
        (39, t.sinh()),
        (40, t.cosh()),
        (41, t.tanh()),
        (42, 1.0),
    ];
    let binary: [(i32, f64); 9] = [
        (2, 1.5 + t * t),
        (3, 1.5 - t * t),
        (4, 1.5 * t * t),
        (5, 1.5 / (t * t)),
        (6, 1.5_f64.powf(t * t)),
        (26, 1.5_f64.atan2(t * t)),
        (34, t * t),
        (35, 1.5),
        (38, 1.5_f64.hypot(t * t)),
    ];
    let first = unary
        .iter()
        .map(|&(op, y)| (program(&[(1, 0.0), (op, 0.0)]), op, y));
    let second = binary.iter().map(|&(op, y)| {
        let square = [(0, 1.5), (1, 0.0), (1, 0.0), (4, 0.0), (op, 0.0)];
        (program(&square), op, y)
    });
    let h = 1e-6;
    for (profile, op, expected) in first.chain(second) {
        let value = profile.value(t);
        assert!((value - expected).abs() < 1e-14, "{op}: {value} {expected}");
        let errors = rate_errors(&profile, t, h);
        assert!(errors.iter().all(|&e| e < 1e-8), "{op}: {errors:?}"); // measured 4e-9
    }
}

#[test]
fn powers_have_rates_where_the_general_rule_fails() {
    let square = program(&[(1, 0.0), (0, 2.0), (6, 0.0)]);
    assert_eq!(square.derivatives(0.0), [0.0, 0.0, 2.0]);
    assert_eq!(square.derivatives(-3.0), [9.0, -6.0, 2.0]);
    let nought = program(&[(1, 0.0), (0, 0.0), (6, 0.0)]);
    assert_eq!(nought.derivatives(0.0), [1.0, 0.0, 0.0]);
    let first = program(&[(1, 0.0), (0, 1.0), (6, 0.0)]);
    assert_eq!(first.derivatives(0.0), [0.0, 1.0, 0.0]);
    let tower = program(&[(1, 0.0), (1, 0.0), (6, 0.0)]); // t^t: rate t^t (ln t + 1)
    let (value, rate) = tower.value_and_rate(2.0);
    assert!((value - 4.0).abs() < 1e-15 && (rate - 4.0 * (LN_2 + 1.0)).abs() < 1e-14);
    let root = program(&[(0, 0.0), (30, 0.0)]); // sqrt(0): constant, though the slope is infinite
    assert_eq!(root.derivatives(1.0), [0.0; 3]);
}

#[test]
fn kinks_take_the_rate_to_the_right() {
    let t = (1, 0.0);
    let back = [t, (7, 0.0)];
    let abs = program(&[t, (31, 0.0)]);
    assert_eq!(abs.value_and_rate(0.0), (0.0, 1.0));
    assert_eq!(
        program(&[back[0], back[1], (31, 0.0)])
            .value_and_rate(0.0)
            .1,
        1.0
    );
    let relu = program(&[t, (0, 0.0), (35, 0.0)]);
    assert_eq!(
        [-1.0, 0.0, 1.0].map(|x| relu.value_and_rate(x).1),
        [0.0, 1.0, 1.0]
    );
    let low = program(&[t, (0, 0.0), (34, 0.0)]);
    assert_eq!(
        [-1.0, 0.0, 1.0].map(|x| low.value_and_rate(x).1),
        [1.0, 0.0, 0.0]
    );
}

#[test]
fn what_is_no_program_is_refused() {
    let refuse = |pairs: &[f64]| Program::new(pairs).unwrap_err();
    assert!(refuse(&[0.0]).contains("pairs"));
    assert!(refuse(&[99.0, 0.0]).contains("unknown instruction 99"));
    assert!(refuse(&[0.5, 0.0]).contains("unknown instruction 0.5"));
    assert!(refuse(&[f64::NAN, 0.0]).contains("unknown"));
    assert!(refuse(&[1.0, 0.0, 2.0, 0.0]).contains("not there"));
    assert!(refuse(&[1.0, 0.0, 1.0, 0.0]).contains("leaves 2"));
    assert!(refuse(&[]).contains("leaves 0"));
    assert!(refuse(&[1.0, 0.0].repeat(300)).contains("more than 64"));
}

#[test]
fn a_schedule_counts_in_its_window_only() {
    let schedule = Schedule {
        profile: shared(Profile::Ramp { over: 2.0 }),
        from: 1.0,
        until: 4.0,
    };
    let factors = [0.5, 1.0, 2.0, 3.9, 4.0].map(|t| schedule.factor(Moment::at(t)));
    assert_eq!(factors, [0.0, 0.0, 0.5, 1.0, 0.0]);
    // Steps of 0.4 s that begin and end with the window: shares of 3/4 and 1/4, the profile at its ends.
    let within = |t: f64, start: f64| schedule.factor(Moment::within(t, (start, 0.4)));
    assert!(within(0.9, 0.9).abs() < 1e-15);
    assert!((within(1.3, 0.9) - 0.75 * 0.15).abs() < 1e-15);
    assert!((within(4.3, 3.9) - 0.25).abs() < 1e-15);
    assert_eq!(schedule.derivatives(2.0), [0.5, 0.5, 0.0]);
    assert_eq!(Schedule::default().derivatives(7.0), [1.0, 0.0, 0.0]);
}

/// Trapezoids on a fine grid: an integral by other means.
fn quadrature(profile: &Profile, to: f64) -> f64 {
    let n = 200_000;
    let h = to / f64::from(n);
    let ends = 0.5 * (profile.value(0.0) + profile.value(to));
    h * (ends + (1..n).map(|k| profile.value(h * f64::from(k))).sum::<f64>())
}

#[test]
fn integrals_agree_with_trapezoids() {
    for profile in smooth_profiles() {
        let integral = Integral::new(shared(profile.clone()));
        for t in [0.1, 0.4, 1.0, 3.0] {
            let error = integral.value(t) - quadrature(&profile, t);
            assert!(error.abs() < 1e-5, "{profile:?} {t} {error}"); // measured 8e-6 at the step, 3e-10 else
        }
        assert_eq!(integral.value(-1.0), 0.0);
    }
    assert_eq!(Integral::new(None).value(2.5), 2.5);
}

/// Of sin(2 pi t) exp(-t) from 0 to t: (w - exp(-t) (sin wt + w cos wt)) / (1 + w^2).
#[test]
fn expressions_integrate_to_rounding() {
    let integral = Integral::new(shared(damped_sine()));
    for t in [0.003_f64, 0.4, 1.9, 7.0] {
        let w = TAU;
        let exact = (w - (-t).exp() * ((w * t).sin() + w * (w * t).cos())) / (1.0 + w * w);
        let error = integral.value(t) - exact;
        assert!(error.abs() < 1e-15, "{t} {error}"); // measured 1e-16
    }
}

/// |sin 40 pi t| has forty kinks a second; over whole seconds its integral is 2/pi each.
#[test]
fn expressions_with_kinks_integrate_well() {
    let profile = program(&[(0, 40.0 * PI), (1, 0.0), (4, 0.0), (20, 0.0), (31, 0.0)]);
    let error = Integral::new(shared(profile)).value(2.0) - 4.0 / PI;
    assert!(error.abs() < 1e-9, "{error}"); // measured 1.5e-11
}

#[test]
fn what_is_kept_does_not_change_a_bit() {
    let fresh = Integral::new(shared(damped_sine()));
    let mut warm = fresh.clone();
    for k in 0..300 {
        let t = 0.011 * f64::from(k);
        warm.observe(t);
        assert_eq!(
            warm.value(t + 0.005).to_bits(),
            fresh.value(t + 0.005).to_bits()
        );
    }
}
