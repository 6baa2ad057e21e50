// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/tracedefinition.h"

#include <QStringList>
#include <QUrl>
#include <algorithm>
#include <cmath>

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString encoded(const QString& text) {
    return QString::fromLatin1(QUrl::toPercentEncoding(text));
}

QString decoded(const QString& text, int most) {
    return QUrl::fromPercentEncoding(text.toUtf8()).simplified().left(most);
}

QString toText(const TraceDefinition::Part& part) {
    return u"%1,%2"_s.arg(part.signal.toText()).arg(part.factor, 0, 'g', 12);
}

std::optional<TraceDefinition::Part> partOf(const QString& signal, const QString& factor) {
    const auto ref = SignalRef::fromText(signal);
    const double number = factor.toDouble();
    if (!ref || customIndex(ref->signal) || !(std::abs(number) >= TraceDefinition::kLeastFactor) ||
        std::abs(number) > TraceDefinition::kMostFactor)
        return std::nullopt;
    return TraceDefinition::Part{*ref, number};
}

}  // namespace

QString TraceDefinition::toText() const {
    QStringList words{encoded(name), encoded(unit), QString::number(cutoff), nmc::toText(first)};
    if (second)
        words << nmc::toText(*second);
    return words.join(u',');
}

std::optional<TraceDefinition> TraceDefinition::fromText(const QString& text) {
    const QStringList words = text.split(u',');
    const auto first = partOf(words.value(3), words.value(4));
    const double cutoff = words.value(2).toDouble();
    if (!first || !(cutoff >= 0 && cutoff <= kMostCutoff))
        return std::nullopt;
    TraceDefinition trace{decoded(words[0], kLongestName), decoded(words[1], kLongestUnit), *first,
                          partOf(words.value(5), words.value(6)), cutoff};
    if (trace.name.isEmpty() || (words.size() > 5 && !trace.second))
        return std::nullopt;
    return trace;
}

std::optional<CustomTrace> TraceDefinition::at(const ModuleSignal& place,
                                               const std::vector<ScopeModule>& modules) const {
    const auto partAt = [&](const Part& part) -> std::optional<CustomSignal::Part> {
        const ModuleIndex index = part.signal.module.value_or(place.module);
        if (index.value() >= modules.size() || !modules[index.value()].reports(part.signal.signal))
            return std::nullopt;
        const LinearScale scale = modules[index.value()].scaleOf(part.signal.signal);
        return CustomSignal::Part{{index, part.signal.signal},
                                  {scale.factor * part.factor, scale.offset * part.factor}};
    };
    CustomTrace trace{name, unit, 1, {place, {}, {}, cutoff}};
    const auto one = partAt(first);
    const auto other = second ? partAt(*second) : std::nullopt;
    if (!one || (second && !other))
        return std::nullopt;
    trace.step = std::abs(one->scale.factor);
    if (other)
        trace.step = std::min(trace.step, std::abs(other->scale.factor));
    const auto inSteps = [&](CustomSignal::Part part) {
        part.scale.factor /= trace.step;
        part.scale.offset /= trace.step;
        return part;
    };
    trace.signal.first = inSteps(*one);
    if (other)
        trace.signal.second = inSteps(*other);
    return trace;
}

std::vector<ScopeModule> withTraces(const std::vector<ScopeModule>& modules,
                                    const TraceDefinitions& definitions) {
    std::vector<ScopeModule> with = modules;
    for (std::size_t k = 0; k < definitions.size(); ++k)
        for (std::size_t i = 0; definitions[k] && i < with.size(); ++i)
            with[i].custom[k] =
                definitions[k]->at({ModuleIndex(static_cast<std::uint8_t>(i)), customSignal(k)}, modules);
    return with;
}

}  // namespace nmc
