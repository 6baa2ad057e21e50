// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "link/connection/busstore.h"
#include "widgets/common/message.h"

namespace nmc {

/// A message about an event of the connection.
struct News {
    /// What ends it, besides the user and its own cause.
    enum class Until : quint8 { Cause, ModuleObeys, ConnectionEnds };

    Message message;
    Until until = Until::Cause;
    /// If it reports that these modules were sent a stop: it is amended when they are seen at rest.
    std::optional<bus::StopCause> stop{};
    std::vector<ModuleIndex> stopped{};
};

/// What an event says to the user, `link` being the state that includes it; beside texts::standing(), which
/// says what holds. Pure.
[[nodiscard]] std::vector<News> newsOf(const StoreEvent& event, const LinkState& link);

/// True for events after which nothing is held any more, whether the panel requested that or not.
[[nodiscard]] bool endsHold(const StoreEvent& event);

}  // namespace nmc
