// SPDX-License-Identifier: MIT
#include "model/response/responsefile.h"

#include "base/numbertext.h"
#include "model/recording/recording.h"

namespace nmc {

namespace {

class Comments {
public:
    Comments(std::string& out, int run) : m_out(out), m_prefix("# run " + textOf(run) + ' ') {}

    void add(std::string_view key, std::string_view value) {
        if (value.empty())
            return;
        m_out.append(m_prefix).append(key).append(": ");
        // Whatever the module's name contains, it becomes one line without commas, so that no spreadsheet
        // splits it.
        for (const char c : value)
            m_out += c == ',' ? ';' : static_cast<unsigned char>(c) < 0x20 ? '?' : c;
        m_out += '\n';
    }
    void add(std::string_view key, const Figure& result, std::string_view unit) {
        if (result)
            add(key, textOf(result->value) + ' ' + std::string(unit) + " +- " + textOf(result->doubt));
    }

private:
    std::string& m_out;
    std::string m_prefix;
};

std::string_view methodText(ResponseMethod method) {
    switch (method) {
        case ResponseMethod::Profile:
            return "by a profile of one tick";
        case ResponseMethod::StopHere:
            return "by Stop Here";
        case ResponseMethod::Move:
            return "by a profiled move";
    }
    return {};
}

void appendMove(Comments& comments, const ResponseRecord& run) {
    const double perSecond = ticksPerSecond(run.taken.gains.sr);
    comments.add("velocity", textOf(toCounts(run.taken.pace.velocity) * perSecond) + " counts/s");
    comments.add("acceleration",
                 textOf(toCounts(run.taken.pace.acceleration) * perSecond * perSecond) + " counts/s2");
    comments.add("move", textOf(run.taken.round));
    comments.add("move time", textOf(run.move->moveTime) + " s");
    comments.add("settling to within " + textOf(run.window.counts) + " counts for " +
                     textOf(run.window.dwell) + " s after the move",
                 run.move->settling, "s");
    comments.add("peak error", run.move->peak, "counts");
    comments.add("RMS error", run.move->rms, "counts");
    comments.add("error at constant velocity", run.move->slew, "counts");
    comments.add("steady-state error", run.metrics.steadyError, "counts");
}

void appendMetrics(Comments& comments, const ResponseRecord& run) {
    if (run.move)
        return appendMove(comments, run);
    comments.add("rise from 10 to 90 %", run.metrics.rise, "s");
    comments.add("overshoot", run.metrics.overshoot, "% of the step");
    const std::string within = "settling to within " + textOf(run.band()) + " counts of ";
    comments.add(within + "the goal", run.metrics.settling, "s");
    comments.add(within + "where it stays", run.metrics.settlingAtRest, "s");
    comments.add("steady-state error", run.metrics.steadyError, "counts");
    if (run.pwm)
        comments.add("peak PWM demand", (run.pwm->limited() ? "limited to " : "at least ") +
                                            textOf(run.pwm->output()) + " of 255");
}

void appendRun(std::string& out, const KeptResponse& kept) {
    const ResponseTaken& taken = kept.run.taken;
    Comments comments(out, kept.number);
    comments.add("name", kept.name);
    comments.add("note", kept.note);
    comments.add("started", kept.startedAt);
    comments.add("port", kept.port);
    comments.add("simulated", kept.simulated ? "yes (no real motor moved)" : "no");
    comments.add("module", kept.moduleName);
    comments.add("counts per unit", textOf(kept.scale.counts(1.0)));
    comments.add("step", textOf(taken.from) + " to " + textOf(taken.goal) + " counts " +
                             std::string(methodText(taken.method)));
    appendGains(out, GainsChange{kept.run.module, taken.at, taken.gains}, taken.at);
    appendMetrics(comments, kept.run);
}

}  // namespace

std::vector<const KeptResponse*> seriesOf(std::span<const KeptResponse> runs, const KeptResponse& run) {
    const auto follows = [](const KeptResponse& before, const KeptResponse& after) {
        const ResponseTaken& a = before.run.taken;
        const ResponseTaken& b = after.run.taken;
        return a.isMove() && b.isMove() && b.round == a.round + 1 && b.from == a.goal && b.pace == a.pace;
    };
    std::vector<const KeptResponse*> series;
    for (const KeptResponse& other : runs) {
        if (other.run.module != run.run.module)
            continue;  // two modules may move at the same time
        if (!series.empty() && !follows(*series.back(), other)) {
            if (series.back()->number >= run.number)
                break;
            series.clear();
        }
        series.push_back(&other);
    }
    return series;
}

std::string responsesCsv(std::string_view program, std::span<const KeptResponse> runs) {
    std::string out = "# NMC Panel step responses 1\n# program: ";
    out.append(program) += '\n';
    for (const KeptResponse& kept : runs)
        appendRun(out, kept);
    out +=
        "# time_s = seconds since the module latched the step\n"
        "# position, from_start and error = counts; error = command position - position\n"
        "run,time_s,position,from_start,error\n";
    for (const KeptResponse& kept : runs)
        for (const ResponsePoint& point : kept.run.points)
            out += textOf(kept.number) + ',' + textOf(point.seconds) + ',' + textOf(point.position) + ',' +
                   textOf(point.position - kept.run.taken.from) + ',' + textOf(kept.run.errorAt(point)) +
                   '\n';
    return out;
}

}  // namespace nmc
