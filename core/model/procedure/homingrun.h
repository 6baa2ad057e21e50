// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "bus/standstill.h"
#include "model/intent/travel.h"
#include "model/procedure/homingchip.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// A search for home from the motor's present position (DS-V 5.2, DS-S 5.1 Set Homing Mode): it backs off
/// from an active switch, searches, makes sure that the motor stops, reads the captured position twice, and,
/// if requested, goes there and makes it zero. A servo that the search itself has switched off is switched on
/// again for the following steps, but never at the end.
///
/// While home is known, and the travel limits are therefore in force, the search goes no farther than these
/// limits and home, plus the distance needed to detect home and to stop. If the position may be wrong, the
/// user must declare that first (intent::DeclarePosition).
///
/// It is done only if every status in between was trustworthy. It ends with the chip no longer searching for
/// home and, on failure, with a stop of a motor that is on.
class HomingRun : public Procedure {
public:
    /// `recipe` must fit the module (model/intent/homingplan.h). `tolerance`: counts from home at which the
    /// motor may rest so that home is still made zero. The report contains the distance that remains when its
    /// time is over.
    HomingRun(HomingRecipe recipe, std::int32_t tolerance, const ModuleState& module)
        : HomingRun(ProcedureKind::Homing, std::move(recipe), tolerance, module) {}

protected:
    HomingRun(ProcedureKind kind, HomingRecipe recipe, std::int32_t tolerance, const ModuleState& module);

    /// Called when the motor stands and ProcedureReport::home has been read: returns what follows.
    [[nodiscard]] virtual Next found(const HomingLook& seen, TimePoint now);
    /// True if the motor must leave what it searches for before the search begins.
    [[nodiscard]] virtual bool leavesFirst(const HomingLook& seen) const { return anyActive(seen); }
    /// True if anything that it searches for is active.
    [[nodiscard]] bool anyActive(const HomingLook& seen) const;
    [[nodiscard]] Next beginSearch(const HomingLook& seen, TimePoint now);
    /// Ends the run.
    [[nodiscard]] Next disarm();
    /// Reverses the direction of the next search.
    void turnRound() { m_recipe.reverse = !m_recipe.reverse; }
    [[nodiscard]] const HomingRecipe& recipe() const { return m_recipe; }

private:
    enum class Sent : std::uint8_t { Nothing, Commands, FirstRead, SecondRead, LastWord };

    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next decide(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next prepare(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next backOff(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next search(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next settle(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next read(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next goHome(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next makeZero(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next sendOrders(HomingChip::Orders orders, Sent what = Sent::Commands);
    [[nodiscard]] Next enter(ProcedureStage stage, TimePoint now, HomingChip::Orders orders);

    [[nodiscard]] bool inIndexSearch() const { return m_round == 2; }
    [[nodiscard]] HomeConditions conditions() const;
    [[nodiscard]] HomingChip::Motion motion() const;
    [[nodiscard]] bool startsUnwatched() const;
    [[nodiscard]] bool tooFar(const HomingLook& seen) const;
    [[nodiscard]] bool beyondTravel(const HomingLook& seen) const;
    [[nodiscard]] bool tooLong(TimePoint now) const;
    [[nodiscard]] bool stands(const HomingLook& seen);

    HomingRecipe m_recipe;
    std::int32_t m_tolerance;
    std::optional<TravelRange> m_range;  ///< the range in which the search may move
    HomingChip m_chip;
    Sent m_sent = Sent::Nothing;
    bool m_goesOff = false;  ///< finding home switches the motor off
    unsigned m_round = 1;    ///< 2: the search for the index, if it is the second one
    bool m_prepared = false;
    bool m_stepSent = false;  ///< within the current stage, the stop, the move or the reset has been sent
    bool m_backedOff = false;
    bool m_watching = false;  ///< the chip has been sent what to search for
    TimePoint m_endedAt;      ///< end of the last operation; older statuses do not reflect it
    TimePoint m_began;        ///< start of the stage, for its time limit
    std::int32_t m_from = 0;  ///< start of the search, for its travel limit
    std::optional<std::int32_t> m_firstReading;
    std::optional<TimePoint> m_offSince;
    std::optional<TimePoint> m_stillSince;
    Standstill m_standstill;
};

}  // namespace nmc
