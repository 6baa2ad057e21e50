// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "model/path/pathplan.h"
#include "tests/procedures/procedurebench.h"

namespace nmc::test {

/// PIC-SERVO CMC or SC modules that hold, and their command positions in the simulator at every tick.
class PathBench : public ProcedureBench {
public:
    static constexpr std::uint8_t kGroup = 0x81;

    explicit PathBench(std::vector<ModuleIdentity> identities, std::uint32_t baud = 115'200)
        : ProcedureBench(identities, {}, baud), m_baud(baud) {
        sliceTime = kServoTick;
        onSlice = [this] { note(); };
        bus.onTime = {};
    }

    std::vector<std::vector<double>> ticks;  ///< command positions of each module since its path started

    /// Makes all modules hold, with an acceleration loaded in each.
    [[nodiscard]] bool hold(std::optional<bool> fastPath = {}) {
        if (!connect())
            return false;
        settle();
        bool all = true;
        for (std::uint8_t i = 0; i < modules.size(); ++i) {
            const servo::SetGain gains{200, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}};
            if (fastPath)
                all = all && ask(i, intent::Direct{control(i, *fastPath)});
            all = all && ask(i, intent::ApplyGains{gains}) && ask(i, intent::Enable{}) &&
                  ask(i, intent::Move{servomotion::Trapezoid{Counts(100), CountsPerTick(4 << 16),
                                                             CountsPerTickSquared(6'554)}});
        }
        settle();
        settle();
        ticks.resize(modules.size());
        return all;
    }
    [[nodiscard]] bool ask(std::uint8_t module, const Intent& intent) {
        const auto steps = plan(intent, modules.at(module));
        const bool done = steps && bus.perform(*steps) == bus::Outcome::Done;
        settle();
        return done;
    }
    /// Puts all modules in one group, with a leader if one is given.
    [[nodiscard]] bool group(std::optional<std::uint8_t> leader = {}) {
        for (std::uint8_t i = 0; i < modules.size(); ++i) {
            bus.engine.submit(bus::GroupOperation{bus::OperationId(1'000U + i),
                                                  bus::GroupChange{ModuleIndex(i), {kGroup, leader == i}}},
                              bus.now);
            settle();
        }
        return bus.count<bus::GroupFinished>() == modules.size();
    }
    /// Swings of this many counts about the position that is held, with a different period for each axis.
    [[nodiscard]] PathTable swings(servo::PathRate rate, std::size_t points, double counts = 600) const {
        PathTable table{rate, {}};
        for (std::uint8_t i = 0; i < modules.size(); ++i) {
            table.columns.push_back({ModuleIndex(i), {}});
            for (std::size_t n = 1; n <= points; ++n) {
                const double turns = static_cast<double>(n) / (150.0 + 37.0 * i);
                const double off = counts * std::sin(2 * std::numbers::pi * turns);
                table.columns.back().points.push_back(100 + static_cast<std::int32_t>(std::lround(off)) +
                                                      static_cast<std::int32_t>(n % 2));
            }
        }
        return table;
    }
    [[nodiscard]] auto planned(const PathTable& table) const {
        return planPath(table, modules, {m_baud, Duration{}});
    }
    void follow(const PathTable& table) {
        take();
        const auto wanted = planned(table);
        ASSERT_TRUE(wanted.has_value()) << static_cast<int>(wanted.error().kind);
        begin(*wanted);
    }
    ProcedureReport runPath(const PathTable& table, double seconds = 60.0) {
        follow(table);
        return procedure ? goOn(seconds) : ProcedureReport{};
    }
    /// Runs the path until this many points are done.
    [[nodiscard]] bool runToPoint(std::size_t point) {
        while (!procedure->report().path || procedure->report().path->done < point)
            if (!turn())
                return false;
        return true;
    }
    /// Number of Add Path Points packets that contain points, from this entry of bus.sent on.
    [[nodiscard]] std::size_t frames(std::size_t from = 0) const {
        std::size_t n = 0;
        for (std::size_t i = from; i < bus.sent.size(); ++i)
            n += isFrame(bus.sent[i].bytes) ? 1U : 0U;
        return n;
    }
    [[nodiscard]] static bool isFrame(ByteSpan packet) {
        return packet.size() > 4 && packet[0] == 0xAA && (packet[2] & 0x0FU) == 0x0D;
    }
    /// True if the command position does not change for two seconds.
    [[nodiscard]] bool stands(std::uint8_t module) {
        const double at = bus.servo(module).commandPosition;
        bus.runFor(std::chrono::seconds(2));
        return bus.servo(module).commandPosition == at;
    }
    /// True if the command position was exactly on each point at the end of the segment leading to it.
    [[nodiscard]] bool wasOnEachPoint(const PathTable& table, std::uint8_t module) const {
        const auto& seen = ticks.at(module);
        const auto& points = table.columns.at(module).points;
        const auto each = static_cast<std::size_t>(servo::ticksPerPoint(table.rate));
        // The start is carried out at the end of a tick or at the beginning of the next.
        for (std::size_t first = 0; first < 3; ++first) {
            bool all = seen.size() > first + each * points.size();
            for (std::size_t i = 0; all && i < points.size(); ++i)
                all = seen[first + each * (i + 1) - 1] == points[i];
            if (all)
                return true;
        }
        return false;
    }

private:
    [[nodiscard]] ServoCommand control(std::uint8_t module, bool fastPath) const {
        if (isSc(modules.at(module).info.identity)) {
            servo::ScIoControl control;
            control.fastPath = fastPath;
            return control;
        }
        servo::IoControl control;
        control.fastPath = fastPath;
        return control;
    }
    void note() {
        for (std::uint8_t i = 0; i < ticks.size(); ++i) {
            const sim::ServoSnapshot now = bus.servo(i);
            if (now.later->pathMode || !ticks[i].empty())
                ticks[i].push_back(now.commandPosition);
        }
    }

    std::uint32_t m_baud;
};

[[nodiscard]] inline std::vector<ModuleIdentity> scs(std::size_t count = 1) {
    return servos(count, kScVersion);
}

}  // namespace nmc::test
