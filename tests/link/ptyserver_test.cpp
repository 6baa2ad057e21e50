// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/terminal/ptyserver.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "link/ports/linerate.h"

namespace nmc {
namespace {

using testing::ElementsAre;

std::string freshPath(const char* name) {
    return testing::TempDir() + name + "-" + std::to_string(::getpid());
}

/// The host's side of the terminal.
class Host {
public:
    explicit Host(const std::string& path) : m_fd(::open(path.c_str(), O_RDWR | O_NOCTTY)) {}
    ~Host() { ::close(m_fd); }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;
    /// Sets the rate, and either keeps the other settings or clears all flags.
    void setBaud(speed_t baud, bool keeping = true) {
        termios settings{};
        ASSERT_EQ(::tcgetattr(m_fd, &settings), 0);
        if (!keeping)
            settings.c_iflag = settings.c_oflag = settings.c_lflag = 0;
        ::cfsetspeed(&settings, baud);
        ASSERT_EQ(::tcsetattr(m_fd, TCSANOW, &settings), 0);
    }
    void flush() { ASSERT_EQ(::tcflush(m_fd, TCIFLUSH), 0); }
    void write(std::vector<std::uint8_t> bytes) {
        ASSERT_EQ(::write(m_fd, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    std::vector<std::uint8_t> read() {
        std::uint8_t buffer[64];
        const auto got = ::read(m_fd, buffer, sizeof buffer);
        return {buffer, buffer + got};
    }

private:
    int m_fd;
};

TEST(PtyServer, CarriesEveryByteValueBothWaysUnchanged) {
    const auto server = PtyServer::create({});
    ASSERT_TRUE(server.has_value());
    Host host(server->path());
    // Among them are those that a terminal interprets: interrupt, end of file, carriage return, line feed,
    // XON, XOFF.
    const std::vector<std::uint8_t> bytes{0x00, 0x03, 0x04, 0x0D, 0x0A, 0x11, 0x13, 0x7F, 0xAA, 0xFF};
    host.write(bytes);
    EXPECT_EQ(server->read(), bytes);
    server->write(bytes);
    EXPECT_EQ(host.read(), bytes);
}

TEST(PtyServer, IsForItsOwnerOnly) {
    const auto server = PtyServer::create({});
    struct stat info {};
    ASSERT_EQ(::stat(server->path().c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777U, 0600U);
}

TEST(PtyServer, IsAt19200UntilTheHostChoosesAnyOtherRate) {
    auto server = PtyServer::create({});
    EXPECT_EQ(server->takeActs().baud, 19'200U);
    Host host(server->path());
    EXPECT_EQ(server->takeActs().baud, 19'200U) << "opening it chooses no rate";
    host.setBaud(B38400);
    EXPECT_EQ(server->takeActs().baud, 38'400U)
        << "the default of a fresh terminal elsewhere, but a choice here";
    host.setBaud(B115200);
    EXPECT_EQ(server->takeActs().baud, 115'200U);
    host.setBaud(B0);
    EXPECT_FALSE(server->takeActs().baud.has_value());
}

TEST(PtyServer, TellsWhetherTheHostWroteOrSetItsRateFirst) {
    auto server = PtyServer::create({});
    Host host(server->path());
    EXPECT_EQ(server->takeActs().first, FirstAct::Unknown) << "it has not done anything yet";
    for (const speed_t rate : {speed_t{B38400}, speed_t{B57600}, speed_t{B115200}}) {
        host.write({1, 2, 3});
        host.setBaud(rate);
        const HostActs wrote = server->takeActs();
        EXPECT_EQ(wrote.first, FirstAct::Wrote);
        EXPECT_THAT(wrote.bytes, ElementsAre(1, 2, 3));
        EXPECT_EQ(wrote.baud, lineRate(server->fd()));

        host.setBaud(B19200);
        host.write({4});
        host.write({5});
        const HostActs set = server->takeActs();
        EXPECT_EQ(set.first, FirstAct::SetTerminal);
        EXPECT_THAT(set.bytes, ElementsAre(4, 5));
        EXPECT_EQ(set.baud, 19'200U);
    }
}

TEST(PtyServer, DoesNotTakeAFlushForANewRate) {
    auto server = PtyServer::create({});
    Host host(server->path());
    host.flush();
    host.write({1});
    host.setBaud(B115200);
    EXPECT_EQ(server->takeActs().first, FirstAct::Unknown);
}

TEST(PtyServer, KnowsThatItIsNotToldOfSettingsMadeFromNothing) {
    auto server = PtyServer::create({});
    Host host(server->path());
    host.setBaud(B38400, false);
    host.write({1});
    EXPECT_EQ(server->takeActs().first, FirstAct::SetTerminal) << "the first change is reported";
    host.setBaud(B115200, false);
    host.write({2});
    EXPECT_EQ(server->takeActs().first, FirstAct::Unknown);
}

TEST(PtyServer, OutlivesAHostThatClosesAndComesBack) {
    const auto server = PtyServer::create({});
    { const Host host(server->path()); }
    EXPECT_TRUE(server->read().empty());
    Host host(server->path());
    host.write({1, 2, 3});
    EXPECT_THAT(server->read(), ElementsAre(1, 2, 3));
}

TEST(PtyServer, TellsThatAHostHasHungUpAndForgetsWhatItHasNotRead) {
    auto server = PtyServer::create({});
    {
        Host host(server->path());
        host.write({1, 2, 3});
        EXPECT_FALSE(server->takeActs().hungUp);
        server->write(std::vector<std::uint8_t>{7, 8, 9});
        host.write({4});
    }
    Host host(server->path());
    const HostActs left = server->takeActs();
    EXPECT_TRUE(left.hungUp);
    EXPECT_THAT(left.bytes, ElementsAre(4));
    server->write(std::vector<std::uint8_t>{10});
    EXPECT_THAT(host.read(), ElementsAre(10));

    // The discarded bytes do not hide what the host does first.
    host.setBaud(B57600);
    host.write({5});
    const HostActs back = server->takeActs();
    EXPECT_FALSE(back.hungUp);
    EXPECT_EQ(back.first, FirstAct::SetTerminal);
}

TEST(PtyServer, MakesItsLinkReplacesAStaleOneAndRemovesItAtTheEnd) {
    const std::string link = freshPath("nmc-link");
    std::filesystem::create_symlink("/dev/pts/nowhere", link);
    {
        const auto server = PtyServer::create(link);
        ASSERT_TRUE(server.has_value());
        EXPECT_EQ(std::filesystem::read_symlink(link), server->path());
    }
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(link)));
}

TEST(PtyServer, NeverReplacesAFile) {
    const std::string path = freshPath("nmc-file");
    std::ofstream(path) << "mine";
    const auto server = PtyServer::create(path);
    EXPECT_FALSE(server.has_value());
    EXPECT_THAT(server.error(), testing::HasSubstr(path));
    EXPECT_TRUE(std::filesystem::is_regular_file(path));
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace nmc
