// SPDX-License-Identifier: MIT
#include "sim/faultinjector.h"

#include <algorithm>
#include <utility>

#include "sim/module.h"

namespace nmc::sim {

namespace {

constexpr std::uint8_t kAllItems = 0x3F;

bool damagesFrames(FaultKind kind) {
    return kind <= FaultKind::Overrun;
}

bool isOnce(FaultKind kind) {
    return kind == FaultKind::PowerCycle || kind == FaultKind::SameAddress || kind == FaultKind::DefineStatus;
}

bool repeats(FaultKind kind) {
    return kind == FaultKind::Noise || kind == FaultKind::Foreign;
}

/// A fault that acts at its beginning and at its end.
bool isState(FaultKind kind) {
    return kind == FaultKind::Stall || kind == FaultKind::Reverse;
}

}  // namespace

// ---- One fault ----

bool FaultInjector::Fault::isActive(TimePoint now) const {
    return now >= begins && now < ends && (!spec.count || struck < *spec.count);
}

bool FaultInjector::Fault::hits(std::uint8_t module) const {
    return spec.onBus() || std::ranges::count(spec.modules, module) > 0;
}

bool FaultInjector::Fault::concerns(CommandCode code) const {
    return !spec.command || *spec.command == code;
}

bool FaultInjector::Fault::strikes(TimePoint now) {
    return isActive(now) && (spec.probability >= 1.0 || random.unit() < spec.probability);
}

Duration FaultInjector::Fault::between() {
    const Duration span = *spec.most - *spec.least;
    return *spec.least +
           Duration(static_cast<Duration::rep>(random.unit() * static_cast<double>(span.count())));
}

// ---- The list ----

unsigned FaultInjector::add(const FaultSpec& spec, TimePoint now) {
    constexpr std::uint64_t kApart = 0x9E37'79B9'7F4A'7C15U;
    ++m_lastNumber;
    Fault fault{spec, m_lastNumber, Random(m_seed ^ kApart * m_lastNumber), {}, kNever, kNever, 0, {}};
    fault.begins = std::max(spec.at.value_or(now), now);
    if (spec.lasts)
        fault.ends = fault.begins + *spec.lasts;
    if (repeats(spec.kind) && !spec.least) {
        const bool noise = spec.kind == FaultKind::Noise;
        fault.spec.least = noise ? std::chrono::milliseconds(5) : std::chrono::milliseconds(100);
        fault.spec.most = noise ? std::chrono::milliseconds(15) : std::chrono::milliseconds(500);
    }
    if (repeats(spec.kind))
        fault.next = fault.begins + fault.between();
    else if (isOnce(spec.kind) || isState(spec.kind) || spec.kind == FaultKind::Break)
        fault.next = fault.begins;
    m_faults.push_back(std::move(fault));
    return m_lastNumber;
}

std::vector<FaultReport> FaultInjector::reports(TimePoint now) const {
    std::vector<FaultReport> all;
    for (const Fault& fault : m_faults) {
        const bool over = isOnce(fault.spec.kind) && fault.struck > 0;
        all.push_back({fault.number, fault.spec.text, fault.struck, fault.isActive(now) && !over});
    }
    return all;
}

// ---- Frames ----

std::optional<FrameEdit> FaultInjector::strikePacket(std::optional<std::uint8_t> module, CommandCode code,
                                                     const FrameInSight& packet, TimePoint now) {
    for (Fault& fault : m_faults) {
        const bool meant = module ? !fault.spec.onBus() && fault.hits(*module) : fault.spec.onBus();
        if (!meant || !damagesFrames(fault.spec.kind) || !fault.spec.sides.command || !fault.concerns(code) ||
            !fault.strikes(now))
            continue;
        if (auto edit = makeEdit(fault.spec.kind, packet, fault.spec.bit, fault.random)) {
            ++fault.struck;
            return edit;
        }
    }
    return std::nullopt;
}

bool FaultInjector::strikesCommand(FaultKind kind, std::uint8_t module, CommandCode code, TimePoint now) {
    for (Fault& fault : m_faults)
        if (fault.spec.kind == kind && fault.hits(module) && fault.concerns(code) && fault.strikes(now)) {
            ++fault.struck;
            return true;
        }
    return false;
}

FaultInjector::ReplyFate FaultInjector::strikeReply(std::uint8_t module, CommandCode code,
                                                    std::vector<std::uint8_t>& bytes, TimePoint now) {
    ReplyFate fate;
    for (Fault& fault : m_faults) {
        if (!fault.spec.sides.status || !fault.hits(module) || !fault.concerns(code))
            continue;
        const FaultKind kind = fault.spec.kind;
        if (kind == FaultKind::Stuck && fault.isActive(now)) {
            const auto same =
                std::ranges::find(fault.stuckReplies, bytes.size(), &std::vector<std::uint8_t>::size);
            if (same == fault.stuckReplies.end())
                fault.stuckReplies.push_back(bytes);
            else
                bytes = *same;
            ++fault.struck;
        } else if (kind == FaultKind::Silent && fault.strikes(now)) {
            ++fault.struck;
            fate.sent = false;
        } else if (kind == FaultKind::Delay && fault.strikes(now)) {
            ++fault.struck;
            (fault.spec.onBus() ? fate.heldUp : fate.begunLater) += fault.between();
        } else if (damagesFrames(kind) && !bytes.empty() && fault.strikes(now)) {
            // A reply that another fault has already cut shorter than this cannot be damaged again.
            if (bytes.size() < 2 || bytes.size() > kMaxPacket)
                continue;
            if (const auto edit =
                    makeEdit(kind, {bytes, bytes.size(), 0, false}, fault.spec.bit, fault.random)) {
                ++fault.struck;
                bytes = edit->applied(bytes);
            }
        }
    }
    return fate;
}

// ---- The line and the module ----

bool FaultInjector::isOn(FaultKind kind, std::uint8_t module, TimePoint now) const {
    return std::ranges::any_of(
        m_faults, [&](const Fault& f) { return f.spec.kind == kind && f.hits(module) && f.isActive(now); });
}

bool FaultInjector::breaks(bool FaultSides::*side, TimePoint now) const {
    return std::ranges::any_of(m_faults, [&](const Fault& f) {
        return f.spec.kind == FaultKind::Break && f.spec.sides.*side && f.isActive(now);
    });
}

bool FaultInjector::strikesByte(FaultKind kind, std::optional<std::uint8_t> module, TimePoint now) {
    bool struck = false;
    for (Fault& fault : m_faults) {
        if (fault.spec.kind != kind || (module && !fault.hits(*module)) || !fault.isActive(now))
            continue;
        ++fault.struck;
        struck = true;
    }
    return struck;
}

// ---- Time ----

TimePoint FaultInjector::nextEvent() const {
    TimePoint next = kNever;
    for (const Fault& fault : m_faults)
        next = std::min(next, fault.next);
    return next;
}

std::vector<FaultInjector::Act> FaultInjector::takeDue(TimePoint now) {
    std::vector<Act> acts;
    for (Fault& fault : m_faults)
        while (fault.next <= now)
            act(fault, acts);
    return acts;
}

void FaultInjector::act(Fault& fault, std::vector<Act>& acts) {
    const TimePoint when = std::exchange(fault.next, kNever);
    const auto forEach = [&](auto&& make) {
        for (std::size_t i = 0; i < m_modules; ++i)
            if (const auto module = static_cast<std::uint8_t>(i); fault.hits(module))
                acts.push_back(make(module));
    };
    if (repeats(fault.spec.kind)) {
        if (!fault.isActive(when))
            return;
        // The interval is at least one byte time at the fastest rate; otherwise time would stand still.
        constexpr Duration kMin = std::chrono::microseconds(80);
        fault.next = when + std::max(fault.between(), kMin);
    }
    switch (fault.spec.kind) {
        case FaultKind::PowerCycle:
            forEach([](std::uint8_t module) { return PowerCycle{module}; });
            break;
        case FaultKind::SameAddress:
            for (const std::uint8_t module : fault.spec.modules)
                acts.emplace_back(GiveAddress{fault.spec.modules.front(), module});
            break;
        case FaultKind::DefineStatus:
            forEach([&fault](std::uint8_t module) {
                return DefineItems{module, static_cast<std::uint8_t>(1 + fault.random.below(kAllItems))};
            });
            break;
        case FaultKind::Noise:
            acts.emplace_back(
                NoiseByte{fault.spec.sides, static_cast<std::uint8_t>(fault.random.below(256))});
            break;
        case FaultKind::Foreign:
            acts.emplace_back(ForeignPacket{static_cast<std::uint8_t>(fault.random.below(m_modules)),
                                            fault.spec.command.value_or(CommandCode::Nop),
                                            static_cast<std::uint8_t>(fault.random.below(kAllItems + 1))});
            break;
        case FaultKind::Break:
            acts.emplace_back(BreakBegins{fault.spec.sides});
            break;
        case FaultKind::Stall:
        case FaultKind::Reverse:
            acts.emplace_back(HoldsChange{});
            if (when >= fault.ends)
                return;
            fault.next = fault.ends;
            break;
        case FaultKind::Drop:
        case FaultKind::Dup:
        case FaultKind::Flip:
        case FaultKind::Collide:
        case FaultKind::Truncate:
        case FaultKind::Garbage:
        case FaultKind::Overrun:
        case FaultKind::Delay:
        case FaultKind::Silent:
        case FaultKind::Cksum:
        case FaultKind::Ignore:
        case FaultKind::Stuck:
        case FaultKind::MuteRx:
        case FaultKind::MuteTx:
        case FaultKind::Echo:
            break;  // these wait for a frame
    }
    ++fault.struck;
}

}  // namespace nmc::sim
