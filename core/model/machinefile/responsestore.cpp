// SPDX-License-Identifier: MIT
#include "model/machinefile/responsestore.h"

#include <algorithm>
#include <limits>

#include "model/intent/looptestplan.h"
#include "model/machinefile/fieldreader.h"
#include "model/machinefile/fieldwriter.h"

namespace nmc {

// The layout of the file, defined once for reading and writing, as in model/machinefile/machinelayout.h.
namespace layout {

namespace {
constexpr int kRunsVersion = 1;
constexpr std::string_view kRunsFormat = "nmc-panel-step-runs";
/// Per run: twice the number of samples that the bus provides in the longest record.
constexpr std::size_t kMostPoints = 20'000;
constexpr Words<ResponseMethod::Move> kMethodWords{"profile", "stop here", "move"};
constexpr Bounds kRecord{kShortestRecord, kLongestMove};
constexpr Bounds kFixedPoint{0, 4294967295.0};
constexpr Bounds kPwm{0, 1e9};

struct Runs {
    std::vector<KeptResponse> runs;
};
}  // namespace

template <typename Form, As<ResponseTaken> T>
void fields(Form& form, T& taken) {
    auto& [at, from, goal, record, method, gains, pace, round] = taken;
    form.whole("from_counts", from, takenByModule(servo::kPositionRange));
    form.whole("goal_counts", goal, takenByModule(servo::kPositionRange));
    form.real("record_s", record, kRecord);
    form.choice("way", method, kMethodWords);
    form.part("gains", gains);
    std::uint32_t velocity = pace.velocity.value();
    std::uint32_t acceleration = pace.acceleration.value();
    form.whole("velocity_fixed_point", velocity, kFixedPoint, Need::Optional);
    form.whole("acceleration_fixed_point", acceleration, kFixedPoint, Need::Optional);
    form.whole("round", round, {1, 2 * kMaxMoves}, Need::Optional);
    if constexpr (!std::is_const_v<T>)
        pace = {CountsPerTick(velocity), CountsPerTickSquared(acceleration)};
}

template <typename Form, As<PwmDemand> T>
void fields(Form& form, T& pwm) {
    auto& [wanted, limit] = pwm;
    form.whole("wanted", wanted, kPwm);
    form.whole("limit", limit, {0, 255});
}

template <typename Form, As<ResponseRecord> T>
void fields(Form& form, T& run) {
    auto& [module, taken, bandPercent, window, points, metrics, move, pwm] = run;
    form.module("module", module);
    form.part("step", taken);
    form.part("pwm", pwm);
    std::vector<double> numbers;
    std::vector<double> errors;
    for (const ResponsePoint& point : points) {
        numbers.insert(numbers.end(), {point.seconds, point.position});
        if (taken.isMove())
            errors.push_back(point.error);
    }
    form.numbers("seconds_and_counts", numbers, 2 * kMostPoints);
    if (taken.isMove())
        form.numbers("errors_counts", errors, kMostPoints);
    if constexpr (!std::is_const_v<T>)
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            points.push_back({numbers[i], numbers[i + 1], i / 2 < errors.size() ? errors[i / 2] : 0.0});
}

template <typename Form, As<KeptResponse> T>
void fields(Form& form, T& kept) {
    auto& [number, name, note, run, startedAt, moduleName, axisName, scale, port, simulated, earlier] = kept;
    form.whole("number", number, {1, std::numeric_limits<int>::max() - 1.0});
    form.text("name", name);
    form.text("note", note);
    form.text("started", startedAt);
    form.text("port", port);
    form.flag("simulated", simulated);
    form.text("module_name", moduleName);
    form.text("axis", axisName);
    AxisUnit unit = scale.unit();
    form.part("unit", unit);
    form.part("run", run);
    if constexpr (!std::is_const_v<T>) {
        scale = AxisScale::servo(unit, run.taken.gains.sr);
        earlier = true;
    }
}

template <typename Form, As<Runs> T>
void fields(Form& form, T& file) {
    form.list("runs", file.runs, kMaxKeptRuns);
}

}  // namespace layout

std::string writeResponses(std::span<const KeptResponse> runs) {
    layout::FieldWriter::Json file;
    file["format"] = layout::kRunsFormat;
    file["version"] = layout::kRunsVersion;
    const layout::Runs all{{runs.begin(), runs.end()}};
    layout::FieldWriter writer(file);
    layout::fields(writer, all);
    return layout::fileText(file);
}

tl::expected<std::vector<KeptResponse>, FileProblem> readResponses(std::string_view text) {
    const auto file = layout::parsed(text, kMaxRunFile, layout::kRunsFormat, layout::kRunsVersion);
    if (!file)
        return tl::unexpected(file.error());
    std::optional<FileProblem> problem;
    layout::Runs read;
    layout::FieldReader reader(*file, problem);
    layout::fields(reader, read);
    for (std::size_t i = 0; i < read.runs.size() && !problem; ++i) {
        ResponseRecord& run = read.runs[i].run;
        if (run.taken.from == run.taken.goal)
            problem = FileProblem{.kind = FileProblem::Kind::OutOfRange,
                                  .line = file->find("runs")->items[i].line,
                                  .field = "goal_counts",
                                  .found = std::to_string(run.taken.goal),
                                  .min = static_cast<double>(servo::kPositionRange.min),
                                  .max = static_cast<double>(servo::kPositionRange.max)};
        else
            judge(run, kFirstBand);
    }
    if (problem)
        return tl::unexpected(*problem);
    return std::move(read.runs);
}

std::string idOf(const KeptResponse& run) {
    return run.startedAt + ' ' + run.port + ' ' + textOf(run.run.module.value());
}

void dropOldest(std::vector<KeptResponse>& runs, const std::function<bool(const KeptResponse&)>& needed) {
    const auto free = [&](const KeptResponse& run) { return !needed || !needed(run); };
    while (runs.size() > kMaxKeptRuns) {
        auto first = std::ranges::find_if(
            runs, [&](const KeptResponse& run) { return free(run) && run.name.empty() && run.note.empty(); });
        if (first == runs.end())
            first = std::ranges::find_if(runs, free);
        if (first == runs.end())
            return;
        runs.erase(first);
    }
}

std::vector<KeptResponse> together(std::vector<KeptResponse> ours, const std::vector<KeptResponse>& there,
                                   const std::set<std::string>& gone) {
    std::set<std::string> ids;
    std::set<int> numbers;
    for (const KeptResponse& run : ours) {
        ids.insert(idOf(run));
        numbers.insert(run.number);
    }
    for (const KeptResponse& run : there) {
        if (gone.contains(idOf(run)) || !ids.insert(idOf(run)).second)
            continue;
        ours.push_back(run);
        if (!numbers.insert(run.number).second)
            ours.back().number = *numbers.insert(*numbers.rbegin() + 1).first;
    }
    std::ranges::stable_sort(ours, {}, &KeptResponse::number);
    dropOldest(ours);
    return ours;
}

}  // namespace nmc
