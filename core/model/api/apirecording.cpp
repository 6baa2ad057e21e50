// SPDX-License-Identifier: MIT
#include "model/api/apirecording.h"

#include "base/time.h"
#include "model/api/apistate.h"

namespace nmc::api {

namespace {

[[nodiscard]] AnalogScale analogScaleOf(const Json& input) {
    return {input.at("per_count").get<double>(), input.at("at_zero").get<double>(),
            input.at("unit").get<std::string>()};
}

[[nodiscard]] RecordingModule moduleOf(const Json& axis) {
    RecordingModule module{.index = ModuleIndex(static_cast<std::uint8_t>(axis.at("number").get<int>() - 1)),
                           .identity = {},
                           .name = axis.at("name").get<std::string>(),
                           .unit = {},
                           .analog = {}};
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Stepper, ModuleType::Io})
        if (axis.at("type") == nameOf(type))
            module.identity = {type, axis.at("version").get<std::uint8_t>()};
    const std::string unit = axis.at("unit").get<std::string>();
    module.unit = {UnitKind::Own, axis.at("counts_per_unit").get<double>(), unit};
    const bool isCounts = module.unit.countsPerUnit == 1.0;  // an own unit may be called that
    for (const UnitKind kind : {UnitKind::Native, UnitKind::Turns, UnitKind::Degrees, UnitKind::Millimetres})
        if (unit == symbolOf({kind}, module.identity.type == ModuleType::Stepper) &&
            (kind != UnitKind::Native || isCounts))
            module.unit = {kind, module.unit.countsPerUnit};
    for (const Json& input : axis.at("analog"))
        if (module.identity.type == ModuleType::Io)
            module.pins.analog.push_back({input.at("name").get<std::string>(), analogScaleOf(input)});
        else
            module.analog = analogScaleOf(input);
    for (const Json& pin : axis.at("pins"))
        module.pins.pins.push_back({.name = pin.at("name").get<std::string>()});
    return module;
}

/// A row is what ApiFeed sends (docs/api.md, "Notifications").
[[nodiscard]] ScopeSample sampleOf(const Json& row, TimePoint time, bool io) {
    const auto orUnknown = [&row](std::size_t i) {
        return row.at(i).is_null() ? ScopeSample::kUnknown : row.at(i).get<float>();
    };
    ScopeSample sample{.time = time};
    if (io)
        sample.setCounter(row.at(1).get<std::uint32_t>());
    else
        sample.position = row.at(1).get<std::int32_t>();
    sample.error = orUnknown(2);
    sample.velocity = orUnknown(3);
    sample.status = row.at(4).get<std::uint8_t>();
    sample.aux = row.at(5).get<std::uint8_t>();
    sample.analog = row.at(6).get<std::uint8_t>();
    sample.gapBefore = row.at(7).get<bool>();
    sample.io = io;
    sample.counted = row.at(8) == true;
    return sample;
}

}  // namespace

ApiRecording::ApiRecording(const Json& state, std::string program, std::string startedAt) {
    m_header.program = std::move(program);
    m_header.startedAt = std::move(startedAt);
    m_header.port = state.at("port").get<std::string>();
    m_header.simulated = state.at("simulated").get<bool>();
    for (const Json& axis : state.at("modules"))
        m_header.modules.push_back(moduleOf(axis));
}

bool ApiRecording::isOfThisChain(const Json& samples) const {
    for (const Json& module : samples.at("modules")) {
        const auto index = module.at("axis").get<std::size_t>() - 1;
        const auto last = m_last.find(index);
        const Json& rows = module.at("rows");
        const bool goesBack =
            last != m_last.end() && !rows.empty() && rows.front().at(0).get<double>() < last->second;
        if (index >= m_header.modules.size() || goesBack)
            return false;
    }
    return true;
}

std::string ApiRecording::rowsOf(const Json& samples) {
    std::string rows;
    if (samples.at("missed") != 0)
        for (std::size_t index = 0; index < m_header.modules.size(); ++index)
            m_gaps.insert(index);
    for (const Json& module : samples.at("modules")) {
        const auto index = module.at("axis").get<std::size_t>() - 1;
        const bool io =
            index < m_header.modules.size() && m_header.modules[index].identity.type == ModuleType::Io;
        for (const Json& row : module.at("rows")) {
            const double time = row.at(0).get<double>();
            m_begin = m_begin.value_or(time);
            m_last[index] = time;
            ScopeSample sample = sampleOf(row, TimePoint(fromSeconds(time - *m_begin)), io);
            sample.gapBefore = m_gaps.erase(index) > 0 || sample.gapBefore;
            appendRow(rows, ModuleIndex(static_cast<std::uint8_t>(index)), sample, m_header.zero);
        }
    }
    return rows;
}

}  // namespace nmc::api
