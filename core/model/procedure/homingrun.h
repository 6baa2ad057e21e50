// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/standstill.h"
#include "model/intent/travel.h"
#include "model/procedure/homingchip.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// One search for home, from where the motor stands (DS-V 5.2, DS-S 5.1 Set Homing Mode): backs off from a
/// switch that is active, searches, sees to it that the motor stops, reads the captured position twice, and
/// where that is wanted goes there and makes it zero. A servo that the search itself has switched off is
/// switched on again for what comes behind it, never at the end.
///
/// While home is known, and so the limits of travel are in force, it looks no farther than they and home are,
/// but for what it takes to notice home and to stop. Where the position may be wrong, that has to be said
/// first (intent::DeclarePosition).
///
/// It is done only if every look at the module in between could be believed; it ends with the chip not
/// watching for home any more, and, when it fails, with a stop of a motor that is on.
class HomingRun : public Procedure {
public:
    /// `recipe` fits the module (model/intent/homingplan.h).
    /// `tolerance`: counts that it may rest off its home for that to become zero. What is still off when it
    /// has had its time is told in the report.
    HomingRun(HomingRecipe recipe, std::int32_t tolerance, const ModuleState& module);

private:
    enum class Sent : std::uint8_t { Nothing, Commands, Enable, FirstRead, SecondRead, LastWord };

    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next decide(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next prepare(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next beginSearch(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next backOff(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next search(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next getUpToSpeed(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next settle(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next read(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next goHome(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next makeZero(const HomingLook& seen, TimePoint now);
    [[nodiscard]] Next disarm();
    [[nodiscard]] Next tell(HomingChip::Orders orders, Sent what = Sent::Commands);
    [[nodiscard]] Next enter(ProcedureStage stage, TimePoint now, HomingChip::Orders orders);

    [[nodiscard]] bool inIndexSearch() const { return m_round == 2; }
    [[nodiscard]] HomeConditions conditions() const;
    [[nodiscard]] HomingChip::Motion motion() const;
    [[nodiscard]] bool startsUnwatched() const;
    [[nodiscard]] bool mayGoOff() const { return m_goesOff; }
    [[nodiscard]] bool anyActive(const HomingLook& seen) const;
    [[nodiscard]] bool tooFar(const HomingLook& seen) const;
    [[nodiscard]] bool beyondTravel(const HomingLook& seen) const;
    [[nodiscard]] bool tooLong(TimePoint now) const;
    [[nodiscard]] bool stands(const HomingLook& seen);

    HomingRecipe m_recipe;
    std::int32_t m_tolerance;
    std::optional<TravelRange> m_range;  ///< where it may look
    HomingChip m_chip;
    Sent m_sent = Sent::Nothing;
    bool m_goesOff = false;  ///< finding home switches the motor off
    unsigned m_round = 1;    ///< 2: the index, where it comes second
    bool m_prepared = false;
    bool m_stepSent = false;  ///< within its stage: the stop, the move, the reset
    bool m_backedOff = false;
    bool m_watching = false;  ///< the chip has been told what to look for
    TimePoint m_endedAt;      ///< when the last operation had ended; older statuses tell nothing about it
    TimePoint m_began;        ///< of a stage's time limit
    std::int32_t m_from = 0;  ///< of a search's travel limit
    std::optional<std::int32_t> m_firstReading;
    std::optional<TimePoint> m_offSince;
    std::optional<TimePoint> m_stillSince;
    Standstill m_standstill;
};

}  // namespace nmc
