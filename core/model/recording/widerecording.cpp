// SPDX-License-Identifier: MIT
#include "model/recording/widerecording.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "base/numbertext.h"
#include "base/text.h"
#include "model/recording/recordingcells.h"
#include "model/scope/derivedsignals.h"

namespace nmc {

namespace {

[[nodiscard]] std::vector<ScopeSignal> signalsOf(ModuleType type) {
    using enum ScopeSignal;
    if (type == ModuleType::Io)
        return {Analog, Analog2, Analog3, Counter, CountRate};
    std::vector<ScopeSignal> motor{Position, Velocity, Command, Error, Analog, Acceleration};
    if (type == ModuleType::Servo)
        motor.push_back(Pwm);
    return motor;
}

[[nodiscard]] DerivedSignals derivedOf(const std::vector<RecordingModule>& modules, const History& history) {
    std::vector<ModuleSignal> wanted;
    std::vector<CustomSignal> custom;
    for (const RecordingModule& module : modules) {
        for (const ScopeSignal signal : signalsOf(module.identity.type))
            wanted.push_back({module.index, signal});
        for (const RecordingTrace& trace : module.custom)
            custom.push_back(trace.signal);
    }
    DerivedSignals derived(std::numeric_limits<std::size_t>::max());
    derived.want(std::move(wanted), custom);
    while (!derived.follow(history)) {
    }
    return derived;
}

/// Part of a column's name: without separators, quotes, blanks, and slashes, which would create a tree.
[[nodiscard]] std::string wordOf(std::string_view text) {
    std::string word(text);
    std::erase(word, '"');
    std::ranges::replace_if(
        word,
        [](char c) {
            return isControl(c) || std::string_view(" ,;\"'/\\").find(c) != std::string_view::npos;
        },
        '_');
    return word;
}

/// Names of the columns that describe the table.
[[nodiscard]] std::string aboutNames(const RecordingHeader& header) {
    std::string names;
    for (const auto& [key, value] : originOf(header))
        names.append(",about/").append(key) += '_' + wordOf(value);
    return names;
}

[[nodiscard]] std::string unitOf(const RecordingModule& module) {
    return wordOf(symbolOf(module.unit, module.identity.type == ModuleType::Stepper));
}

class WideModule {
public:
    /// `seen` provides the rows; `derived` are the derived signals of `history`.
    WideModule(const RecordingModule& module, const ModuleHistory& seen, const DerivedSignals& derived,
               const History& history)
        : m_module(module), m_history(seen) {
        for (const ScopeSignal signal : signalsOf(module.identity.type))
            m_columns.push_back({signal});
        for (const RecordingTrace& trace : m_module.custom)
            m_columns.push_back({trace.signal.of.signal, &trace});
        for (Column& column : m_columns)
            if (isDerived(column.signal))
                column.derived = derived.source(history, {module.index, column.signal}).samples;
    }

    [[nodiscard]] const ModuleHistory& history() const { return m_history; }

    void appendNames(std::string& out) const {
        const std::string number = textOf(m_module.index.value() + 1);
        const std::string name = wordOf(m_module.name);
        // Two modules may have the same name, so it stands alone only if it contains the number itself.
        const std::string prefix = (name.find(number) != std::string::npos ? ',' + name
                                    : name.empty()                         ? ",module" + number
                                                   : ",module" + number + '_' + name) +
                                   '/';
        if (m_io)
            return appendIoNames(out, prefix);
        const std::string unit = unitOf(m_module);
        out += prefix + "position_" + unit + prefix + "velocity_" + unit + "_per_s" + prefix + "command_" +
               unit + prefix + "error_" + unit + prefix + "analog_" + wordOf(m_module.analog.unit) + prefix +
               "acceleration_" + unit + "_per_s2";
        if (m_module.identity.type == ModuleType::Servo)
            out += prefix + "pwm_calculated";
        appendCustomNames(out, prefix);
        out += prefix + "status";
    }
    void appendEmpty(std::string& out) const { out.append(m_columns.size() + 1, ','); }
    void append(std::string& out, const ScopeSample& sample) const {
        for (const Column& column : m_columns)
            appendCell(
                out, column,
                column.derived != nullptr ? derivedAt(sample.time, column) : valueOf(sample, column.signal));
        appendStatus(out, sample);
    }
    void appendAt(std::string& out, TimePoint time) const {
        const auto [before, after] = m_history.around(time);
        if (!before || (before->time != time && (!after || after->gapBefore)))
            return appendEmpty(out);
        if (before->time == time)
            return append(out, *before);
        const double share = toSeconds(time - before->time) / toSeconds(after->time - before->time);
        for (const Column& column : m_columns) {
            const auto from = valueOf(*before, column.signal);
            const auto to = valueOf(*after, column.signal);
            const bool whole = m_io || infoOf(column.signal).unit == SignalInfo::Unit::Analog;
            appendCell(out, column,
                       column.derived != nullptr ? derivedAt(time, column)
                       : whole                   ? from
                       : from && to              ? std::optional(*from + share * (*to - *from))
                                                 : std::nullopt);
        }
        appendStatus(out, *before);
    }

private:
    struct Column {
        ScopeSignal signal;
        const RecordingTrace* custom = nullptr;  ///< null unless it is the user's
        const ModuleHistory* derived = nullptr;  ///< its values if no sample contains them
    };
    [[nodiscard]] static std::optional<double> derivedAt(TimePoint time, const Column& column) {
        return column.derived->valueAt(time, ScopeSignal::Error);
    }
    void appendCustomNames(std::string& out, const std::string& prefix) const {
        for (const RecordingTrace& trace : m_module.custom)
            out += prefix + wordOf(trace.name) + (trace.unit.empty() ? "" : '_' + wordOf(trace.unit));
    }
    /// Column names as the user has named the inputs; the pins are the bits of one number, where IO1 is 1.
    void appendIoNames(std::string& out, const std::string& prefix) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const AnalogInput input = PinSettings::of(m_module.pins.analog, i);
            const std::string name = input.name.empty() ? "AD" + textOf(i + 1) : wordOf(input.name);
            out += prefix + name + '_' + wordOf(input.scale.unit);
        }
        out += prefix + "count" + prefix + "count_rate_per_s";
        appendCustomNames(out, prefix);
        out += prefix + "pins";
        for (std::size_t i = 0; i < m_module.pins.pins.size(); ++i)
            if (const std::string& name = m_module.pins.pins[i].name; !name.empty())
                out += "_IO" + textOf(i + 1) + '_' + wordOf(name);
    }
    void appendCell(std::string& out, const Column& column, std::optional<double> value) const {
        out += ',';
        if (!value)
            return;
        if (column.custom != nullptr)
            return appendNumber(out, *value * column.custom->step);
        if (m_io) {
            const auto input = infoOf(column.signal).analogInput;
            const AnalogScale scale =
                input ? PinSettings::of(m_module.pins.analog, *input).scale : AnalogScale{1, 0, {}};
            return appendNumber(out, scale.atZero + *value * scale.perCount);
        }
        const bool bare = m_module.unit.kind == UnitKind::Native || column.signal == ScopeSignal::Pwm;
        const double perUnit = bare ? 1.0 : m_module.unit.countsPerUnit;
        appendNumber(out, column.signal == ScopeSignal::Analog
                              ? m_module.analog.atZero + *value * m_module.analog.perCount
                              : *value / perUnit);
    }
    static void appendStatus(std::string& out, const ScopeSample& sample) {
        out += ',';
        appendNumber(out, sample.status + (sample.io ? sample.aux << 8U : 0));
    }

    const RecordingModule& m_module;
    const ModuleHistory& m_history;
    bool m_io = m_module.identity.type == ModuleType::Io;
    std::vector<Column> m_columns;
};

/// `about`: the empty cells at the end of each row, with the end of the line; the same in appendEven().
void appendSparse(std::string& out, const std::vector<WideModule>& modules, TimePoint zero,
                  const std::string& about) {
    struct Row {
        ScopeSample sample;
        std::size_t module;
    };
    std::vector<Row> rows;
    for (std::size_t i = 0; i < modules.size(); ++i)
        for (const ScopeSample& sample : modules[i].history().samples(TimePoint::min(), TimePoint::max()))
            rows.push_back({sample, i});
    std::ranges::stable_sort(rows, [](const Row& a, const Row& b) { return a.sample.time < b.sample.time; });
    for (const Row& row : rows) {
        out += cells::timeText(row.sample.time - zero);
        for (std::size_t i = 0; i < modules.size(); ++i)
            i == row.module ? modules[i].append(out, row.sample) : modules[i].appendEmpty(out);
        out += about;
    }
}

void appendEven(std::string& out, const std::vector<WideModule>& modules, TimePoint zero,
                const std::string& about, Duration interval) {
    std::optional<TimePoint> first, last;
    for (const WideModule& module : modules) {
        const auto samples = module.history().keptSince();
        first = std::min(first.value_or(*samples), *samples);
        const TimePoint end = module.history().last()->time;
        last = std::max(last.value_or(end), end);
    }
    if (!first)
        return;
    interval = std::max(interval, (*last - *first) / kMaxWideRows + Duration(1));
    // Rows are on whole intervals from the start, as in the long form.
    auto step = (*first - zero) / interval;
    if (zero + step * interval < *first)
        ++step;
    for (; zero + step * interval <= *last; ++step) {
        out += cells::timeText(step * interval);
        for (const WideModule& module : modules)
            module.appendAt(out, zero + step * interval);
        out += about;
    }
}

}  // namespace

std::string wideRecordingOf(const RecordingHeader& header, const History& history, Duration interval,
                            TimePoint from, TimePoint to) {
    const History seen = history.cut(from, to);
    std::vector<RecordingModule> shown;
    for (std::size_t i = 0; i < seen.modules(); ++i) {
        const ModuleIndex index(static_cast<std::uint8_t>(i));
        if (seen.module(index)->empty())
            continue;
        const auto described = std::ranges::find(header.modules, index, &RecordingModule::index);
        shown.push_back(described != header.modules.end() ? *described
                                                          : RecordingModule{index, {}, {}, {}, {}});
    }
    const DerivedSignals derived = derivedOf(shown, history);
    std::vector<WideModule> modules;
    for (const RecordingModule& module : shown)
        modules.emplace_back(module, *seen.module(module.index), derived, history);
    std::string out(kWideTime);
    for (const WideModule& module : modules)
        module.appendNames(out);
    const std::string names = aboutNames(header);
    out += names + '\n';
    const auto columns = static_cast<std::size_t>(std::ranges::count(names, ','));
    const std::string about = std::string(columns, ',') + '\n';
    if (interval > Duration::zero())
        appendEven(out, modules, header.zero, about, interval);
    else
        appendSparse(out, modules, header.zero, about);
    return out;
}

}  // namespace nmc
