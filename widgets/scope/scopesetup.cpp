// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopesetup.h"

#include <QStringList>
#include <algorithm>

#include "widgets/scope/timewindow.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

const std::array<std::pair<QString, ModuleType>, 3> kBitWords{{{u"servobits"_s, ModuleType::Servo},
                                                               {u"stepbits"_s, ModuleType::Stepper},
                                                               {u"iobits"_s, ModuleType::Io}}};

QString toWords(const std::vector<ScopeBit>& bits) {
    QStringList words;
    for (const ScopeBit& bit : bits)
        words << QString::number(bit.number());
    return words.join(u',');
}

std::vector<ScopeBit> bitsIn(const QString& text) {
    std::vector<ScopeBit> bits;
    for (const QString& word : text.split(u',', Qt::SkipEmptyParts)) {
        bool ok = false;
        const int number = word.toInt(&ok);
        if (ok && number >= 0 && number < 16)
            bits.push_back({number >= 8 ? ScopeBit::Byte::Aux : ScopeBit::Byte::Status,
                            static_cast<std::uint8_t>(number % 8)});
    }
    return bits;
}

}  // namespace

ScopeSetup ScopeSetup::usual() {
    ScopeSetup setup;
    setup.strips[0] = {{std::nullopt, ScopeSignal::Position}, {std::nullopt, ScopeSignal::Command}};
    setup.strips[1] = {{std::nullopt, ScopeSignal::Error}};
    setup.strips[2] = {{std::nullopt, ScopeSignal::Analog},
                       {std::nullopt, ScopeSignal::Analog2},
                       {std::nullopt, ScopeSignal::Analog3}};
    return setup;
}

ScopeSetup ScopeSetup::forTuning() {
    ScopeSetup setup = usual();
    setup.strips[2].clear();
    setup.heights.fill(1);
    return setup;
}

QString ScopeSetup::toText() const {
    QStringList parts;
    for (const auto& strip : strips) {
        QStringList words;
        for (const SignalRef& signal : strip)
            words << signal.toText();
        parts << u"strip="_s + words.join(u',');
    }
    parts << u"lane="_s + (lane ? u"1"_s : u"0"_s) << u"seconds="_s + QString::number(seconds);
    parts << u"readings="_s + (readings ? u"1"_s : u"0"_s);
    QStringList shares;
    for (const double height : heights)
        shares << QString::number(height);
    parts << u"heights="_s + shares.join(u',');
    for (const auto& [type, chosen] : bits)
        for (const auto& [word, of] : kBitWords)
            if (of == type)
                parts << word + u'=' + toWords(chosen);
    for (std::size_t i = 0; i < custom.size(); ++i)
        if (custom[i])
            parts << SignalRef{{}, customSignal(i)}.toText() + u'=' + custom[i]->toText();
    return parts.join(u';');
}

ScopeSetup ScopeSetup::fromText(const QString& text, const ScopeSetup& initial) {
    ScopeSetup setup = initial;
    for (std::vector<SignalRef>& signalsShown : setup.strips)
        signalsShown.clear();
    std::size_t strip = 0;
    for (const QString& part : text.split(u';')) {
        const QString key = part.section(u'=', 0, 0);
        const QString value = part.section(u'=', 1);
        if (key == u"strip"_s && strip < kStrips) {
            for (const QString& word : value.split(u',', Qt::SkipEmptyParts))
                if (const auto signal = SignalRef::fromText(word); signal && !setup.shows(strip, *signal))
                    setup.strips[strip].push_back(*signal);
            ++strip;
        } else if (key == u"lane"_s) {
            setup.lane = value == u"1"_s;
        } else if (key == u"readings"_s) {
            setup.readings = value != u"0"_s;
        } else if (key == u"heights"_s) {
            const QStringList shares = value.split(u',');
            for (std::size_t i = 0; i < kStrips; ++i)
                if (const double share = shares.value(static_cast<qsizetype>(i)).toDouble();
                    share >= kLowest && share <= kHighest)
                    setup.heights[i] = share;
        } else if (key == u"seconds"_s) {
            if (const double seconds = value.toDouble();
                seconds >= TimeWindow::kShortest && seconds <= TimeWindow::kLongest)
                setup.seconds = seconds;
        }
        for (std::size_t i = 0; i < kCustomSignals; ++i)
            if (key == SignalRef{{}, customSignal(i)}.toText())
                setup.custom[i] = TraceDefinition::fromText(value);
        for (const auto& [word, type] : kBitWords)
            if (key == word)
                setup.bits[type] = bitsIn(value);
    }
    const bool nothing = std::ranges::all_of(setup.strips, [](const auto& shown) { return shown.empty(); });
    if (nothing && !setup.lane)
        setup.strips = initial.strips;
    return setup;
}

bool ScopeSetup::shows(std::size_t strip, const SignalRef& signal) const {
    return std::ranges::find(strips[strip], signal) != strips[strip].end();
}

void ScopeSetup::set(std::size_t strip, const SignalRef& signal, bool shown) {
    std::erase(strips[strip], signal);
    if (!shown)
        return;
    // In the order of the table from which they are chosen.
    const auto place = std::lower_bound(strips[strip].begin(), strips[strip].end(), signal);
    strips[strip].insert(place, signal);
}

std::vector<ScopeBit> ScopeSetup::bitsOf(ModuleType type) const {
    const auto chosen = bits.find(type);
    return chosen != bits.end() ? chosen->second : usualLaneBits(type);
}

std::vector<ModuleIndex> ScopeSetup::fixedModules() const {
    std::vector<ModuleIndex> modules;
    const auto add = [&](const SignalRef& signal) {
        if (signal.module && std::ranges::find(modules, *signal.module) == modules.end())
            modules.push_back(*signal.module);
    };
    for (const auto& strip : strips)
        for (const SignalRef& signal : strip) {
            add(signal);
            const auto index = customIndex(signal.signal);
            if (!index || !custom[*index])
                continue;
            add(custom[*index]->first.signal);
            if (custom[*index]->second)
                add(custom[*index]->second->signal);
        }
    return modules;
}

}  // namespace nmc
