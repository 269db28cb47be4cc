// SPDX-License-Identifier: MIT
#include <plumb/ballistics/quadratic_drag_flight.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <plumb/ballistics/detail/input.h>
#include <plumb/integrate/integrate.h>
#include <plumb/math/detail/length.h>

namespace plumb {
namespace {

/// x, y, x', y' in units of U^2 / g for lengths, U for speeds and U / g for times, so that one tolerance fits all.
using FlightState = Eigen::Vector4d;

struct Moment {
    double time = 0;
    FlightState state{0, 0, 0, 0};
};

class Flight {
public:
    Flight(const Vec2& velocity, const QuadraticDrag& drag)
        : speed_(unitOf(velocity, drag)),
          gravity_(drag.gravity),
          strength_(drag.coefficient * (speed_ / gravity_) * speed_),
          start_{0, {0, 0, velocity.x() / speed_, velocity.y() / speed_}} {}

    const Moment& start() const { return start_; }
    double lengthUnit() const { return speed_ * (speed_ / gravity_); }
    double timeUnit() const { return speed_ / gravity_; }

    /// From a moment to a later time.
    Moment at(const Moment& from, double time) const {
        const double straight = from.time + steadyAfter();
        const auto made = integrate(*this, from.time, from.state, std::min(time, straight), settings);
        if (made.end != IntegrationEnd::Reached) return nowhere();
        Moment moment{made.time, made.state};
        if (time > straight) moment = fallStraight(moment, time - straight);
        return moment;
    }

    /// The first moment at which an entry of the state falls to a value.
    Moment fallsTo(const Moment& from, int index, double value) const {
        const auto above = [=](double, const FlightState& state) { return state[index] - value; };
        const auto found = integrateUntil(*this, from.time, from.state, from.time + steadyAfter(), above,
                                          ZeroCrossing::Falling, settings);
        if (found.end == IntegrationEnd::Reached)
            return fallStraight({found.time, found.state}, (found.state[index] - value) * std::sqrt(strength_));
        if (found.end != IntegrationEnd::Crossed) return nowhere();
        // The crossing was found on the interpolant of a step, which is less accurate than the steps.
        Moment moment = at(from, found.time);
        for (int i = 0; i < 3; ++i) {
            const double slope = (*this)(moment.time, moment.state)[index];
            const double step = (value - moment.state[index]) / slope;
            if (!std::isfinite(step)) break;
            moment = at(moment, moment.time + step);
        }
        return moment;
    }

    /// The derivative of the state.
    FlightState operator()(double, const FlightState& s) const {
        const double drag = strength_ * std::sqrt(s[2] * s[2] + s[3] * s[3]);
        return {s[2], s[3], -drag * s[2], -1 - drag * s[3]};
    }

    std::optional<FlightPoint> point(const Moment& moment) const {
        const FlightPoint made{lengthUnit() * moment.state.head<2>(), speed_ * moment.state.tail<2>(),
                               timeUnit() * moment.time};
        if (!made.position.allFinite() || !made.velocity.allFinite() || !std::isfinite(made.time)) return std::nullopt;
        return made;
    }

private:
    static constexpr AdaptiveSettings settings{.absoluteTolerance = 1e-14, .relativeTolerance = 1e-13};

    /// The smaller of the speed of the launch and the terminal speed.
    static double unitOf(const Vec2& velocity, const QuadraticDrag& drag) {
        const double speed = detail::lengthOf(velocity), terminal = terminalSpeed(drag);
        return speed > 0 ? std::min(speed, terminal) : std::min(terminal, 1.0);
    }

    /// After this time the horizontal speed, which decays as exp(-g t / V), is less than 1e-19 of the terminal one, V.
    double steadyAfter() const { return 45 / std::sqrt(strength_); }

    /// Where the integration fails, because numbers leave their range.
    static Moment nowhere() {
        constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
        return {notANumber, FlightState::Constant(notANumber)};
    }

    Moment fallStraight(const Moment& from, double time) const {
        Moment moment = from;
        moment.time += time;
        moment.state[1] -= time / std::sqrt(strength_);
        moment.state[2] = 0;
        moment.state[3] = -1 / std::sqrt(strength_);
        return moment;
    }

    double speed_, gravity_, strength_;
    Moment start_;
};

void requireLaunch(const Vec2& velocity, const QuadraticDrag& drag) {
    detail::requireSize(velocity, "quadratic drag: ", "velocity");
    terminalSpeed(drag);  // checks it
}

FlightPoint parabola(const Vec2& velocity, double time, double gravity) {
    return {{velocity.x() * time, (velocity.y() - 0.5 * gravity * time) * time},
            {velocity.x(), velocity.y() - gravity * time},
            time};
}

/// When a parabola falls to a height below the muzzle; -1: never.
double parabolaLanding(const Vec2& velocity, double height, double gravity) {
    const double square = velocity.y() * velocity.y() + 2 * gravity * height;
    if (square < 0) return -1;
    const double root = std::sqrt(square);
    return velocity.y() > 0 ? (velocity.y() + root) / gravity : 2 * height / (root - velocity.y());
}

}  // namespace

std::optional<FlightPoint> quadraticDragFlight(const Vec2& velocity, double time, const QuadraticDrag& drag) {
    requireLaunch(velocity, drag);
    detail::requireAmount(time, "quadratic drag: ", "time");
    if (drag.coefficient == 0) return parabola(velocity, time, drag.gravity);
    const Flight flight(velocity, drag);
    return flight.point(flight.at(flight.start(), time / flight.timeUnit()));
}

std::optional<FlightPoint> quadraticDragApex(const Vec2& velocity, const QuadraticDrag& drag) {
    requireLaunch(velocity, drag);
    if (!(velocity.y() > 0)) return std::nullopt;
    if (drag.coefficient == 0) return parabola(velocity, velocity.y() / drag.gravity, drag.gravity);
    const Flight flight(velocity, drag);
    return flight.point(flight.fallsTo(flight.start(), 3, 0));
}

std::optional<FlightPoint> quadraticDragLanding(const Vec2& velocity, double height, const QuadraticDrag& drag) {
    requireLaunch(velocity, drag);
    detail::requireSize(height, "quadratic drag: ", "height");
    if (!(velocity.y() > 0) && !(height > 0)) {
        if (height < 0) return std::nullopt;
        return FlightPoint{{0, 0}, velocity, 0};
    }
    if (drag.coefficient == 0) {
        const double time = parabolaLanding(velocity, height, drag.gravity);
        if (!(time >= 0)) return std::nullopt;
        return parabola(velocity, time, drag.gravity);
    }
    const Flight flight(velocity, drag);
    const Moment top = velocity.y() > 0 ? flight.fallsTo(flight.start(), 3, 0) : flight.start();
    const double ground = -height / flight.lengthUnit();
    if (!(top.state[1] >= ground)) return std::nullopt;
    return flight.point(top.state[1] == ground ? top : flight.fallsTo(top, 1, ground));
}

}  // namespace plumb
