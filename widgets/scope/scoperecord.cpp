// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scoperecord.h"

#include <QCoreApplication>

#include "widgets/common/dates.h"
#include "widgets/common/words.h"

namespace nmc {

RecordingHeader recordingHeader(const std::vector<ScopeModule>& modules, const QString& port, bool simulated,
                                TimePoint zero, const QDateTime& date) {
    RecordingHeader header;
    header.program = "NMC Panel " + QCoreApplication::applicationVersion().toStdString();
    header.startedAt = isoDate(date).toStdString();
    header.zero = zero;
    header.port = port.toStdString();
    header.simulated = simulated;
    for (std::size_t i = 0; i < modules.size(); ++i) {
        header.modules.push_back({ModuleIndex(static_cast<std::uint8_t>(i)), modules[i].identity,
                                  modules[i].name.toStdString(), modules[i].scale.unit(),
                                  modules[i].analogOf(ScopeSignal::Analog), modules[i].pins});
        for (const auto& trace : modules[i].custom)
            if (trace)
                header.modules.back().custom.push_back(
                    {trace->name.toStdString(), trace->unit.toStdString(), trace->step, trace->signal});
    }
    return header;
}

ScopeRecord recordOf(const QString& title, const RecordingHeader& header, History history) {
    ScopeRecord record;
    record.title = title;
    for (std::size_t i = 0; i < history.modules(); ++i) {
        const ModuleIndex index(static_cast<std::uint8_t>(i));
        const auto described =
            std::find_if(header.modules.begin(), header.modules.end(),
                         [&](const RecordingModule& module) { return module.index == index; });
        if (described == header.modules.end() && history.module(index)->empty())
            continue;
        record.modules.resize(i + 1);
        ScopeModule& module = record.modules.back();
        if (described == header.modules.end())
            continue;
        module.name = QString::fromStdString(described->name);
        module.identity = described->identity;
        module.scale = described->identity.type == ModuleType::Stepper ? AxisScale::step(described->unit)
                                                                       : AxisScale::servo(described->unit, 1);
        module.analog = described->analog;
        module.pins = described->pins;
    }
    for (std::size_t i = 0; i < record.modules.size(); ++i)
        if (record.modules[i].name.isEmpty())
            record.modules[i].name = texts::moduleName(ModuleIndex(static_cast<std::uint8_t>(i)));
    QDateTime began = dateIn(header.startedAt);
    if (began.isValid() && history.zero())
        began = began.addMSecs(qRound64(toSeconds(*history.zero() - header.zero) * 1e3));
    record.origin = ScopeOrigin{QString::fromStdString(header.port), header.simulated, began};
    record.history = std::move(history);
    return record;
}

}  // namespace nmc
