// SPDX-License-Identifier: MIT
#include "model/intent/travel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/overloaded.h"
#include "base/time.h"
#include "bus/standstill.h"
#include "model/intent/backlash.h"
#include "model/intent/jog.h"
#include "model/intent/stepperplan.h"
#include "model/module/servodefaults.h"

namespace nmc {

namespace {

/// The error that rounding to the chip's numbers may add.
constexpr double kVelocityGrain = 1.0 / kFixedPointOne;

[[nodiscard]] std::optional<std::int32_t> absolute(std::int32_t home, std::optional<std::int32_t> limit) {
    if (!limit)
        return std::nullopt;
    const std::int64_t place = std::int64_t{home} + *limit;
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(place, servo::kPositionRange.min, servo::kPositionRange.max));
}

/// The effect of an intent on its axis.
struct Course {
    std::optional<std::int64_t> goal{};
    std::optional<bool> reverse{};       ///< for a motion without a goal
    double velocity = 0.0;               ///< native; 0: none that is subject to the limit
    std::optional<std::int32_t> from{};  ///< if not the present position
    bool turns = false;                  ///< takes up backlash, if the axis has any
};

/// The effect of a motion, or of a load once it is started.
[[nodiscard]] Course courseOf(const ServoMotion& motion, const ModuleState& /*module*/) {
    Course course{.velocity = std::visit([](const auto& any) { return toCounts(any.velocity); }, motion)};
    if (const auto* run = std::get_if<servomotion::VelocityProfile>(&motion))
        course.reverse = run->reverse;
    return course;
}
[[nodiscard]] Course courseOf(const stepper::LoadTrajectory& load, const ModuleState& module) {
    Course course{.velocity = speedOf(load, module)};
    if (load.position)
        course.goal = load.position->value();
    else
        course.reverse = load.reverse;
    return course;
}
[[nodiscard]] Course courseOf(const StepperMotion& motion, const ModuleState& module) {
    return courseOf(loadFor(motion, module), module);
}

struct CourseOf {
    const ModuleState& module;

    std::optional<Course> operator()(const intent::Move& move) const { return of(move.motion, true); }
    /// A loaded move is started separately, so it goes straight to its goal without taking up backlash.
    std::optional<Course> operator()(const intent::LoadMove& load) const { return of(load.motion); }
    std::optional<Course> operator()(const intent::ChangeMotion& change) const {
        return of(change.motion, true);
    }
    std::optional<Course> operator()(const intent::GoHome& home) const {
        const auto motion = motionOf(home, module);
        return motion ? std::optional(of(*motion, true)) : std::nullopt;
    }
    std::optional<Course> operator()(const intent::DrivePwm& drive) const {
        return drive.pwm == 0 ? std::nullopt : std::optional(Course{.reverse = drive.reverse});
    }
    std::optional<Course> operator()(
        const AnyOf<intent::Home, intent::MeasureRepeatability> auto& search) const {
        const HomingRecipe& recipe = search.recipe;
        return Course{.velocity = recipe.thenIndex ? std::max(recipe.velocity, recipe.indexVelocity)
                                                   : recipe.velocity};
    }
    /// The course extends to the farther side; whyNot() checks both.
    std::optional<Course> operator()(const intent::SquareWave& wave) const { return about(wave.counts / 2); }
    /// On a ramp, the fastest sine adds its own velocity.
    std::optional<Course> operator()(const intent::FrequencyResponse& sines) const {
        auto course = about(sines.amplitude);
        if (course && sines.speed != 0.0 && module.gains)
            course->velocity = std::abs(sines.speed) + 2 * std::numbers::pi * sines.to * sines.amplitude /
                                                           ticksPerSecond(module.gains->sr);
        return course;
    }
    // StartLoaded, Direct, MoveBy, StepResponse, StepSeries and CheckDirection are handled in
    // travelProblem(), and the points of a path in planPath().
    template <typename T>
    requires In<T, AnyModuleIntent> || In<T, MotorSetting> || In<T, ServoSetting> || In<T, StepperSetting> ||
        In<T, IoIntent> || AnyOf<T, intent::MoveBy, intent::StepResponse, intent::StepSeries,
                                 intent::TryGains, intent::CheckDirection, intent::FollowPath>
            std::optional<Course>
    operator()(const T&) const { return std::nullopt; }

private:
    [[nodiscard]] std::optional<Course> about(std::int32_t counts) const {
        const auto from = module.goal();
        return from ? std::optional(Course{.goal = std::int64_t{*from} + counts, .from = from})
                    : std::nullopt;
    }
    [[nodiscard]] Course of(const MotionSpec& motion, bool turns = false) const {
        Course course = std::visit([this](const auto& chip) { return courseOf(chip, module); }, motion);
        course.goal = goalOf(motion, module.position().value_or(0));
        course.turns = turns && course.goal;
        return course;
    }
};

[[nodiscard]] std::optional<TravelProblem> tooFast(double velocity, const ModuleState& module) {
    const double set = module.travel.fastest;
    const double chip = module.isServo() ? servodefaults::fastest(module.info.identity)
                                         : std::numeric_limits<double>::infinity();
    const bool ofChip = set <= 0.0 || set > chip;
    if (velocity <= (ofChip ? chip : set + kVelocityGrain))
        return std::nullopt;
    return TravelProblem{
        .refusal = Refusal::TooFast, .velocity = velocity, .fastest = ofChip ? chip : set, .ofChip = ofChip};
}

[[nodiscard]] std::optional<TravelProblem> atTheEnd(bool reverse, const ModuleState& module) {
    const auto end = travelEnd(module, reverse);
    const auto position = module.position();
    if (!end || !position)
        return std::nullopt;
    const std::int64_t ahead = std::int64_t{*end} - *position;
    if ((reverse ? -ahead : ahead) > kStillCounts)
        return std::nullopt;
    return TravelProblem{.refusal = Refusal::AtTravelEnd, .lowest = reverse, .limit = *end};
}

/// The problem of a move that goes to `turn` first, if there is one.
[[nodiscard]] std::optional<TravelProblem> moveProblem(std::int64_t from, std::int64_t goal,
                                                       std::optional<std::int64_t> turn,
                                                       const TravelRange& range) {
    if (auto problem = turn ? beyondTravel(from, *turn, range) : std::nullopt) {
        // The move must turn round before the limit.
        problem->nearest = static_cast<std::int32_t>(problem->limit + (goal - *turn));
        if (!beyondTravel(from, goal, range))
            problem->turn = static_cast<std::int32_t>(*turn);
        return problem;
    }
    return beyondTravel(from, goal, range);
}

[[nodiscard]] std::optional<TravelProblem> problemOf(const Course& course, const ModuleState& module) {
    if (const auto fast = tooFast(course.velocity, module))
        return fast;
    if (course.reverse)
        return atTheEnd(*course.reverse, module);
    const auto range = travelRange(module);
    const auto position = course.from ? course.from : module.position();
    if (!course.goal || !range || !position)
        return std::nullopt;
    const auto turn = course.turns ? turningPoint(*course.goal, module) : std::nullopt;
    return moveProblem(*position, *course.goal, turn, *range);
}

/// Checks two moves: the first one, which may be the only one that has to take up the backlash, and then the
/// one to the last goal, or back.
[[nodiscard]] std::optional<TravelProblem> problemOf(const intent::MoveBy& by, const ModuleState& module) {
    const MotionSpec pace = moveTo(0, by.pace);
    const double velocity =
        std::visit([&module](const auto& chip) { return courseOf(chip, module); }, pace).velocity;
    if (const auto fast = tooFast(velocity, module))
        return fast;
    const auto range = travelRange(module);
    const auto position = module.position();
    if (!range || !position)
        return std::nullopt;
    const std::int64_t from = module.goal().value_or(*position);
    const std::int64_t first = from + by.moves.counts;
    const std::int64_t last = from + std::int64_t{std::max(by.moves.rounds, 1U)} * by.moves.counts;
    const bool back = by.moves.backAndForth;
    for (const auto& [start, goal] :
         {std::pair(from, first), std::pair(back ? first : from, back ? from : last)})
        if (const auto problem = moveProblem(start, goal, turningPoint(start, goal, module), *range))
            return problem;
    return std::nullopt;
}

/// The problem of the first step that leaves the travel. Each step begins where the previous one ends.
[[nodiscard]] std::optional<TravelProblem> problemOf(const intent::StepSeries& series,
                                                     const ModuleState& module) {
    const bool moves = series.each.method == ResponseMethod::Move;  // a jump has no velocity
    if (const auto fast = tooFast(moves ? toCounts(series.each.pace.velocity) : 0.0, module))
        return fast;
    const auto range = travelRange(module);
    const auto held = module.goal();
    if (!range || !held)
        return std::nullopt;
    std::int64_t from = *held;
    for (const std::int32_t counts : series.counts) {
        if (const auto problem = beyondTravel(from, from + counts, *range))
            return problem;
        from += counts;
    }
    return std::nullopt;
}

/// The effect of a load once it is started.
[[nodiscard]] Course courseOf(const servo::LoadTrajectory& load, const ModuleState& module) {
    Course course;
    if (!load.isTrapezoidal())
        course.reverse = load.reverse;
    else if (load.position && load.relative)
        course.goal =
            std::int64_t{module.goal().value_or(module.position().value_or(0))} + load.position->value();
    else if (load.position)
        course.goal = load.position->value();
    // A velocity that is not loaded is the one loaded before.
    if (load.servo)
        course.velocity = toCounts(load.velocity.value_or(module.velocity.value_or(CountsPerTick())));
    return course;
}

/// The problem of a load that is sent or started unchanged: a run would not end at the limit ahead.
[[nodiscard]] std::optional<TravelProblem> asItStands(const Course& course, const ModuleState& module) {
    if (const auto end = course.reverse ? travelEnd(module, *course.reverse) : std::nullopt)
        return TravelProblem{.refusal = Refusal::AtTravelEnd, .lowest = *course.reverse, .limit = *end};
    return problemOf(course, module);
}

/// The problem of a load that starts now. A PWM value is refused only at the limit, as DrivePwm is.
[[nodiscard]] std::optional<TravelProblem> startProblem(const servo::LoadTrajectory& load,
                                                        const ModuleState& module) {
    const Course course = courseOf(load, module);
    return load.servo ? asItStands(course, module) : problemOf(course, module);
}

/// The problem of a single command of either chip, if it may move the motor at once.
struct DirectProblem {
    const ModuleState& module;

    std::optional<TravelProblem> operator()(const servo::LoadTrajectory& load) const {
        // One that waits is checked when it is started.
        return load.startNow ? startProblem(load, module) : std::nullopt;
    }
    std::optional<TravelProblem> operator()(const stepper::LoadTrajectory& load) const {
        return load.startNow ? asItStands(courseOf(load, module), module) : std::nullopt;
    }
    std::optional<TravelProblem> operator()(const servo::StopMotor& stop) const {
        if (stop.manner != servo::StopManner::Here)
            return std::nullopt;
        return problemOf(Course{.goal = stop.here.value()}, module);
    }
    std::optional<TravelProblem> operator()(const StartMotion&) const { return loadedProblem(module); }
    template <typename Other>
    std::optional<TravelProblem> operator()(const Other&) const {
        return std::nullopt;
    }
};

/// A push may go in either direction.
[[nodiscard]] std::optional<TravelProblem> problemOf(const intent::CheckDirection& check,
                                                     const ModuleState& module) {
    const auto position = module.position();
    if (!position)
        return std::nullopt;
    for (const std::int64_t offset : {std::int64_t{check.reach}, -std::int64_t{check.reach}})
        if (const auto problem = problemOf(Course{.goal = *position + offset}, module))
            return problem;
    return std::nullopt;
}

}  // namespace

TravelForce travelForce(const ModuleState& module) {
    if (!module.travel.limited())
        return TravelForce::NotSet;
    return module.home.place() && !module.hasRestarted ? TravelForce::InForce : TravelForce::HomeUnknown;
}

std::optional<TravelRange> travelRange(const ModuleState& module) {
    if (travelForce(module) != TravelForce::InForce)
        return std::nullopt;
    const std::int32_t home = module.home.place()->counts;
    return TravelRange{absolute(home, module.travel.lowest), absolute(home, module.travel.highest)};
}

std::optional<std::int32_t> travelEnd(const ModuleState& module, bool reverse) {
    const auto range = travelRange(module);
    if (!range)
        return std::nullopt;
    return reverse ? range->lowest : range->highest;
}

TravelPlace travelPlace(const ModuleState& module) {
    const auto range = travelRange(module);
    const auto position = module.position();
    if (!range || !position)
        return TravelPlace::Within;
    if (range->highest && samePlace(*position, *range->highest))
        return TravelPlace::AtHighest;
    if (range->lowest && samePlace(*position, *range->lowest))
        return TravelPlace::AtLowest;
    if (range->highest && *position > *range->highest)
        return TravelPlace::AboveHighest;
    return range->lowest && *position < *range->lowest ? TravelPlace::BelowLowest : TravelPlace::Within;
}

std::optional<TravelProblem> beyondTravel(std::int64_t from, std::int64_t goal, const TravelRange& range) {
    // From outside the limits, a move may lead back, but no farther away.
    if (range.highest && goal > std::max<std::int64_t>(*range.highest, from))
        return TravelProblem{.lowest = false, .limit = *range.highest, .nearest = *range.highest};
    if (range.lowest && goal < std::min<std::int64_t>(*range.lowest, from))
        return TravelProblem{.lowest = true, .limit = *range.lowest, .nearest = *range.lowest};
    return std::nullopt;
}

std::optional<TravelProblem> travelProblem(const Intent& intent, const ModuleState& module) {
    if (const auto* check = std::get_if<intent::CheckDirection>(&intent))
        return problemOf(*check, module);
    if (const auto* by = std::get_if<intent::MoveBy>(&intent))
        return problemOf(*by, module);
    if (const auto* step = std::get_if<intent::StepResponse>(&intent))
        return problemOf(intent::StepSeries{*step, {step->counts}}, module);
    if (const auto* series = std::get_if<intent::StepSeries>(&intent))
        return problemOf(*series, module);
    if (std::holds_alternative<intent::StartLoaded>(intent))
        return loadedProblem(module);
    if (const auto* direct = std::get_if<intent::Direct>(&intent))
        return visitCommand(DirectProblem{module}, direct->command);
    const auto course = std::visit(CourseOf{module}, intent);
    return course ? problemOf(*course, module) : std::nullopt;
}

std::optional<TravelProblem> loadedProblem(const ModuleState& module) {
    if (const auto load = module.waiting())
        return startProblem(*load, module);
    const auto& waits = module.stepper.waiting;
    return waits ? asItStands(courseOf(*waits, module), module) : std::nullopt;
}

tl::expected<bus::HoldToMove, TravelProblem> withinTravel(bus::HoldToMove hold, const ModuleState& module) {
    if (const auto problem = travelProblem(intent::Move{runOf(hold)}, module))
        return tl::unexpected(*problem);
    hold.goal = travelEnd(module, hold.reverse);
    return hold;
}

ServoMotion withinTravel(const ServoMotion& motion, const ModuleState& module) {
    if (const auto* run = std::get_if<servomotion::VelocityProfile>(&motion))
        if (const auto end = travelEnd(module, run->reverse))
            return servomotion::Trapezoid{Counts(*end), run->velocity, run->acceleration};
    return motion;
}

StepperMotion withinTravel(const StepperMotion& motion, const ModuleState& module) {
    if (const auto* run = std::get_if<steppermotion::VelocityProfile>(&motion))
        if (const auto end = travelEnd(module, run->reverse))
            return steppermotion::Trapezoid{*end, false, run->speed, run->accelerationTime};
    if (const auto* run = std::get_if<steppermotion::UnprofiledRun>(&motion))
        if (const auto end = travelEnd(module, run->reverse))
            return steppermotion::UnprofiledMove{*end, false, run->timer};
    return motion;
}

}  // namespace nmc
