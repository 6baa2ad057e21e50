// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "link/guardian/guardreport.h"
#include "tests/link/guardian/guardhost.h"

namespace nmc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing_support::ReportFolder;

using Packets = std::vector<std::vector<std::uint8_t>>;

/// 16 nulls and the packets; by default stops for modules 1 and 3, a packet to the group of all, and the
/// nulls between them.
StopBurst burst(const Packets& packets = {{0xAA, 0x01, 0x17, 0x05, 0x1D, 0x00, 0x00},
                                          {0xAA, 0x03, 0x17, 0x05, 0x1F, 0x00, 0x00},
                                          {0xAA, 0xFF, 0x17, 0x05, 0x1B, 0x00, 0x00}}) {
    std::vector<std::uint8_t> bytes(16, 0);
    for (const std::vector<std::uint8_t>& packet : packets)
        bytes.insert(bytes.end(), packet.begin(), packet.end());
    return *StopBurst::of(bytes, 19'200);
}

void write(const std::string& file, const std::string& text) {
    std::ofstream(file) << text;
}

TEST(GuardReport, SaysOnceWhichModulesWereTold) {
    const ReportFolder folder;
    ASSERT_TRUE(writeGuardReport(folder.file(), burst()));
    const auto reports = takeGuardReports(folder.path());
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_THAT(reports[0].modules, ElementsAre(1, 3));
    EXPECT_THAT(takeGuardReports(folder.path()), IsEmpty()) << "reported once";
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// A PIC-I/O is sent its outputs and its PWM values, and a servo with gains on trial those before them first.
TEST(GuardReport, NamesAModuleOnceThatWasSentSeveralPackets) {
    const ReportFolder folder;
    ASSERT_TRUE(writeGuardReport(folder.file(), burst({{0xAA, 0x02, 0x26, 0x0A, 0x00, 0x32},
                                                       {0xAA, 0x02, 0x24, 0x64, 0x00, 0x8A},
                                                       {0xAA, 0x01, 0xE6, 0x64, 0x00, 0xE8, 0x03, 0x32, 0x00,
                                                        0xC8, 0x00, 0xFF, 0x00, 0xA0, 0x0F, 0x01, 0x00, 0xDF},
                                                       {0xAA, 0x01, 0x17, 0x05, 0x1D}})));
    const auto reports = takeGuardReports(folder.path());
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_THAT(reports[0].modules, ElementsAre(2, 1));
}

TEST(GuardReport, OfTwoPanelsAreTwo) {
    const ReportFolder folder;
    ASSERT_TRUE(writeGuardReport(folder.file(), burst()));
    ASSERT_TRUE(writeGuardReport(guardReportFile(folder.path()), burst()));
    EXPECT_EQ(takeGuardReports(folder.path()).size(), 2U);
}

TEST(GuardReport, LeavesAloneWhatIsNone) {
    const ReportFolder folder;
    write(folder.path() + "/guardian-2.report", "nmcguard 2 stopped 1");
    write(folder.path() + "/guardian-3.report", "");
    write(folder.path() + "/notes.txt", "nmcguard 1 stopped 1");
    ASSERT_EQ(::mkdir((folder.path() + "/guardian-4.report").c_str(), 0700), 0);
    ASSERT_EQ(::mkfifo((folder.path() + "/guardian-5.report").c_str(), 0600), 0);
    EXPECT_THAT(takeGuardReports(folder.path()), IsEmpty());
    EXPECT_TRUE(std::filesystem::exists(folder.path() + "/notes.txt"));
    EXPECT_THAT(takeGuardReports(folder.path() + "/not/there"), IsEmpty());
}

TEST(GuardReport, ThatWasTamperedWithNamesNoModuleThatThereCannotBe) {
    const ReportFolder folder;
    write(folder.file(), "nmcguard 1 stopped 2 -1 900 5");
    const auto reports = takeGuardReports(folder.path());
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_THAT(reports[0].modules, ElementsAre(2));
}

TEST(GuardReport, IsNotWrittenWhereNobodyMay) {
    EXPECT_FALSE(writeGuardReport("/proc/nmc/guardian-1.report", burst()));
}

TEST(StopBurst, ThatDoesNotFitWholeIsNone) {
    EXPECT_TRUE(StopBurst::of(std::vector<std::uint8_t>(StopBurst::kCapacity), 19'200));
    EXPECT_FALSE(StopBurst::of(std::vector<std::uint8_t>(StopBurst::kCapacity + 1), 19'200));
}

}  // namespace
}  // namespace nmc
