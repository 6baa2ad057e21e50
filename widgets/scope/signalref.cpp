// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/signalref.h"

#include <algorithm>

namespace nmc {

using namespace Qt::StringLiterals;

QString SignalRef::toText() const {
    const std::string_view name = infoOf(signal).word;
    const QString word = QLatin1String(name.data(), static_cast<qsizetype>(name.size()));
    return module ? u"%1.%2"_s.arg(module->value() + 1).arg(word) : word;
}

std::optional<SignalRef> SignalRef::fromText(const QString& text) {
    SignalRef ref;
    QString word = text.trimmed();
    if (const qsizetype dot = word.indexOf(u'.'); dot >= 0) {
        const int number = word.left(dot).toInt();
        if (number < 1 || number > 32)
            return std::nullopt;
        ref.module = ModuleIndex(static_cast<std::uint8_t>(number - 1));
        word = word.mid(dot + 1);
    }
    const auto found = std::ranges::find(kSignals, word.toStdString(), &SignalInfo::word);
    if (found == kSignals.end())
        return std::nullopt;
    ref.signal = found->signal;
    return ref;
}

}  // namespace nmc
