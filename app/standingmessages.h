// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <map>
#include <optional>

#include "model/module/linkstate.h"

namespace nmc {

/// When the messages of a connection are over: each with its cause, and all of them with the connection, so
/// that none tells of what is mended, and none acts on the modules of another chain. Knows messages by their
/// keys; each call that ends some returns these. A message that is not told of here is for others to end.
class StandingMessages {
public:
    /// Whether the cause is still there.
    using Stands = bool (*)(const ModuleState& module);

    void whileConnected(const QString& key) { m_standing[key] = {}; }
    void whileTrue(const QString& key, ModuleIndex module, Stands stands) {
        m_standing[key] = {.module = module, .stands = stands};
    }
    /// Until the module carries out another operation.
    void untilObeyed(const QString& key, ModuleIndex module) { m_standing[key] = {.module = module}; }
    /// Of a motor that may move on, whoever is connected.
    void untilChainFound(const QString& key) { m_standing[key] = {.outlivesConnection = true}; }

    [[nodiscard]] QStringList look(const LinkState& link);
    [[nodiscard]] QStringList obeyed(ModuleIndex module);
    /// The chain has been looked for anew: what still stands is told again, or seen in the state.
    [[nodiscard]] QStringList chainFound();
    [[nodiscard]] QStringList connectionEnded();

private:
    struct Standing {
        std::optional<ModuleIndex> module{};
        Stands stands = nullptr;
        bool outlivesConnection = false;
    };
    template <typename Over>
    QStringList end(Over over);

    std::map<QString, Standing> m_standing;
};

}  // namespace nmc
