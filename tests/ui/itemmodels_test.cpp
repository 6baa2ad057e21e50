// SPDX-License-Identifier: GPL-3.0-or-later
// Checks Qt's requirements of an item model for all models of the window, while their contents change at
// random.
#include "sim/random.h"
#include "widgets/chain/chainmodel.h"
#include "widgets/monitor/packetmodel.h"
#include "windowtest.h"

namespace nmc {
namespace {

constexpr int kChanges = 300;

/// The tester warns of errors, and a warning fails the test.
using Demands = QAbstractItemModelTester;
constexpr auto kWarns = QAbstractItemModelTester::FailureReportingMode::Warning;

class ItemModels : public testing::TestWithParam<int> {
protected:
    [[nodiscard]] std::size_t below(std::size_t limit) { return random.below(limit); }
    [[nodiscard]] bool oneIn(std::size_t times) { return below(times) == 0; }

    LinkState anyLink() {
        std::vector<ModuleState> modules;
        for (std::size_t i = below(5); i > 0; --i) {
            Servo servo{.index = static_cast<int>(modules.size()), .on = !oneIn(3)};
            servo.position = static_cast<int>(below(100'000));
            modules.push_back(servo.state());
            modules.back().silent = oneIn(4);
        }
        LinkState link = connectedTo(std::move(modules));
        constexpr std::array kPhases{LinkPhase::Disconnected, LinkPhase::Connecting, LinkPhase::Connected,
                                     LinkPhase::Connected, LinkPhase::Lost};
        link.phase = kPhases[below(kPhases.size())];
        link.port = oneIn(2) ? "/dev/ttyUSB0" : "simulator";
        return link;
    }
    Machine anyMachine() {
        Machine machine;
        machine.axes.resize(below(4));
        for (AxisSettings& axis : machine.axes)
            axis.name = oneIn(2) ? "X" : "";
        return machine;
    }
    /// Consecutive records with a gap here and there; long ones fill the log.
    std::vector<bus::ExchangeRecord> records(std::size_t count, bool longOnes) {
        std::vector<bus::ExchangeRecord> records(count);
        for (bus::ExchangeRecord& record : records) {
            number += oneIn(5) ? 3U : 1U;
            record.number = number;
            record.sent = TimePoint(std::chrono::milliseconds(number));
            record.command = {0xAA, 0x01, 0x0E, 0x0F};
            if (longOnes)
                record.command.resize(PacketLog::kMaxRecordBytes);
            record.purpose = oneIn(2) ? bus::Purpose::Poll : bus::Purpose::Operation;
        }
        return records;
    }
    PacketFilter anyFilter() {
        PacketFilter filter;
        if (oneIn(2))
            filter.kind = oneIn(2) ? PacketKind::Poll : PacketKind::Command;
        filter.onlyErrors = oneIn(4);
        return filter;
    }
    sim::Random random{static_cast<std::uint64_t>(GetParam())};
    std::uint64_t number = 0;
};

TEST_P(ItemModels, TheChainKeepsThem) {
    ChainModel model;
    const Demands demands(&model, kWarns);
    int most = 0;
    for (int i = 0; i < kChanges; ++i) {
        model.showLink(anyLink(), anyMachine(), {});
        most = std::max(most, model.rowCount());
    }
    EXPECT_GT(most, 3);
}

TEST_P(ItemModels, ThePacketsKeepThem) {
    PacketModel model;
    model.append(records(PacketLog::kMaxBytes / PacketLog::kMaxRecordBytes, true));
    const Demands demands(&model, kWarns);
    int dropped = 0;
    for (int i = 0; i < kChanges; ++i) {
        switch (below(20)) {
            case 0:
                model.setFilter(anyFilter());
                break;
            case 1:
                model.setFilter({});
                break;
            case 2:
                model.interrupt();
                break;
            case 3:
                if (oneIn(9))
                    model.clear();
                break;
            default:
                dropped += model.append(records(below(4), oneIn(2)));
        }
    }
    EXPECT_GT(dropped, 0) << "otherwise the log was never full";
    model.begin({});
    EXPECT_EQ(model.rowCount(), 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ItemModels, testing::Range(1, 4));

/// The models of Qt's table and tree widgets, which the window itself fills; a new list is found here
/// automatically.
class WindowsItemModels : public WindowTest {};

TEST_F(WindowsItemModels, KeepThem) {
    find(u"responseDock"_s)->show();
    find(u"monitorDock"_s)->show();
    std::vector<std::unique_ptr<Demands>> demands;
    for (const auto* view : window->findChildren<QAbstractItemView*>())
        if (view->model() != nullptr && qobject_cast<const QHeaderView*>(view) == nullptr)
            demands.push_back(std::make_unique<Demands>(view->model(), kWarns));
    EXPECT_GT(demands.size(), 4U);
    for (int i = 0; i < 40; ++i) {
        std::vector<Servo> servos(static_cast<std::size_t>(i % 4));
        for (Servo& servo : servos)
            servo.position = servo.millisecond = i;
        showServos(std::move(servos));
        if (i % 7 == 0)
            window->showLink({});
    }
}

}  // namespace
}  // namespace nmc
