#pragma once

/// What the law of contact comes to where it can be worked out with pen and paper: nothing here
/// knows a grid, a tick or a float. What a laboratory measures, and the engine, is held to it. SI
/// units; no allocation, any thread.
namespace onggi::lab::closed_form {

/// Press that is left `seconds` after a tool was put `press` (m) deep into clay of relaxation time
/// `tau` (s) and held: a Maxwell element, l0 e^(-t/tau).
double held_press(double press, double tau, double seconds);

/// The same of a tool that goes on at `speed` (m/s): v tau + (l0 - v tau) e^(-t/tau).
double moving_press(double press, double speed, double tau, double seconds);

/// Area that circles of radii `a` and `b` (m, > 0) share, whose middles are `apart` (m, >= 0), m^2.
double lens_area(double a, double b, double apart);

/// Volume that a ball of radius `ball` shares with an endless cylinder of radius `cylinder`, whose
/// axis is `distance` from the ball's middle, m^3: level lenses, summed by Gauss and Legendre to
/// 1e-10 of it.
double lens_volume(double ball, double cylinder, double distance);

/// Force (N) at first touch of a ball `depth` deep in such a cylinder, `stiffness` (N/m^3) times
/// press times area, as the depth goes to nothing: k pi depth^2 sqrt(a b), where 1/a = 1/ball +
/// 1/cylinder and b = ball are the radii of the gap (Hertz's geometry). Off by a share of depth /
/// ball.
double light_force(double ball, double cylinder, double depth, double stiffness);

/// Force (N) on a ball that is `depth` deep in a wide flat face: `stiffness` (N/m^3) times press
/// times its part along the face's normal, a plain sum over rings.
double flat_force(double ball, double depth, double stiffness);

/// Radius (m) of clay that was `outer` once a ball held `distance` from the axis has cut it for
/// many turns, `above` (m) the ball's middle: the envelope min(outer, distance - sqrt(ball^2 -
/// above^2)).
double groove(double outer, double ball, double distance, double above);

/// A wall whose faces are cones: radii at the foot and at the rim, and how far the rim is up, m.
struct ConicWall {
  double foot_outer, foot_inner, rim_outer, rim_inner, height;
};
/// What the part of it above `from` (m, 0..height) weighs, N: frusta, density (kg/m^3) and 9.81.
double weight_above(const ConicWall& wall, double from, double density);

/// Stress (Pa) along one way, after `seconds`, of clay that bore `stress` and yields at `yield`
/// (Pa, > 0), Bingham's of `viscosity` (Pa s): w' = -w (w - yield) / (3 viscosity), since its area
/// grows with its strain. Its height is less by the same factor.
double sagging_stress(double stress, double yield, double viscosity, double seconds);

/// How far a column sinks in the end (m) of which each height bears as much as `from` to `to` (m)
/// of clay of its own, and can bear `stands` (m): a height z that bore too much is shorter by
/// stands / z.
double sagged_end(double from, double to, double stands);

}  // namespace onggi::lab::closed_form
