// SPDX-License-Identifier: GPL-3.0-or-later
// A device server in this process, which a test plays by hand.
#include "link/connection/networktransport.h"

#include <gtest/gtest.h>

#include <netinet/in.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <thread>

#include "link/clock.h"

namespace nmc {
namespace {

using Bytes = std::vector<std::uint8_t>;

class Server {
public:
    Server() {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(::bind(m_listener.get(), reinterpret_cast<sockaddr*>(&address), size), 0);
        EXPECT_EQ(::listen(m_listener.get(), 1), 0);
        EXPECT_EQ(::getsockname(m_listener.get(), reinterpret_cast<sockaddr*>(&address), &size), 0);
        m_port = ntohs(address.sin_port);
    }
    [[nodiscard]] std::uint16_t port() const { return m_port; }
    void accept() { m_client = Descriptor(::accept(m_listener.get(), nullptr, nullptr)); }
    Bytes read(std::size_t size) const {
        Bytes bytes(size);
        bytes.resize(static_cast<std::size_t>(
            std::max<ssize_t>(::recv(m_client.get(), bytes.data(), size, MSG_WAITALL), 0)));
        return bytes;
    }
    void write(const Bytes& bytes) const {
        EXPECT_EQ(::send(m_client.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
    }
    void hangUp() { m_client.reset(); }
    void stopListening() { m_listener.reset(); }

private:
    Descriptor m_listener{::socket(AF_INET, SOCK_STREAM, 0)};
    Descriptor m_client;
    std::uint16_t m_port = 0;
};

class NetworkTransportTest : public testing::Test {
protected:
    [[nodiscard]] NetworkTransport transport(NetworkLine::Protocol protocol,
                                             std::uint32_t baud = 19'200) const {
        return {{protocol, "127.0.0.1", server.port()}, "the line", baud};
    }
    [[nodiscard]] Bytes received(NetworkTransport& transport) const {
        const auto bytes = transport.receive(std::nullopt, wake.get());
        EXPECT_TRUE(bytes);
        return bytes.value_or(Bytes{});
    }
    Server server;
    Descriptor wake{::eventfd(0, EFD_CLOEXEC)};
};

TEST_F(NetworkTransportTest, PassesTheBytesOfARawLineOn) {
    NetworkTransport line = transport(NetworkLine::Protocol::Raw, 115'200);
    ASSERT_TRUE(line.open());
    server.accept();
    EXPECT_TRUE(line.hasFixedRate());
    EXPECT_GT(line.latency(), Duration::zero()) << "measured";
    ASSERT_TRUE(line.send(Bytes{0xAA, 0xFF, 0x0F}));
    EXPECT_EQ(server.read(3), (Bytes{0xAA, 0xFF, 0x0F}));
    server.write({1, 255, 2});
    EXPECT_EQ(received(line), (Bytes{1, 255, 2}));
    EXPECT_EQ(line.onWire(Bytes{0xFF}, 115'200), Bytes{0xFF});
}

TEST_F(NetworkTransportTest, IsMuteAtARateThatARawLineDoesNotHave) {
    NetworkTransport line = transport(NetworkLine::Protocol::Raw);
    ASSERT_TRUE(line.open());
    server.accept();
    ASSERT_TRUE(line.setBaud(9'600));
    ASSERT_TRUE(line.send(Bytes{1}));
    server.write({2});
    EXPECT_EQ(received(line), Bytes{});
    ASSERT_TRUE(line.setBaud(19'200));
    ASSERT_TRUE(line.send(Bytes{3}));
    EXPECT_EQ(server.read(1), Bytes{3});
    server.write({4});
    EXPECT_EQ(received(line), Bytes{4});
}

TEST_F(NetworkTransportTest, ReturnsWhenItIsWokenOrTheTimeHasPassed) {
    NetworkTransport line = transport(NetworkLine::Protocol::Raw);
    ASSERT_TRUE(line.open());
    EXPECT_EQ(line.receive(monotonicNow(), wake.get()).value(), Bytes{});
    EXPECT_EQ(::eventfd_write(wake.get(), 1), 0);
    EXPECT_EQ(received(line), Bytes{});
}

TEST_F(NetworkTransportTest, DropsWhatHasArrived) {
    NetworkTransport line = transport(NetworkLine::Protocol::Raw);
    ASSERT_TRUE(line.open());
    server.accept();
    server.write({1, 2, 3});
    EXPECT_TRUE(line.receive(std::nullopt, wake.get()));
    server.write({4, 5, 6});
    std::array<pollfd, 1> fds{{{line.fd(), POLLIN, 0}}};
    ASSERT_EQ(pollUntil(fds, std::nullopt), 1);
    line.discardInput();
    server.write({7});
    EXPECT_EQ(received(line), Bytes{7});
}

TEST_F(NetworkTransportTest, LosesALineThatHangsUp) {
    NetworkTransport line = transport(NetworkLine::Protocol::Raw);
    ASSERT_TRUE(line.open());
    server.accept();
    server.hangUp();
    const auto bytes = line.receive(std::nullopt, wake.get());
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().problem, PortProblem::Gone);
    EXPECT_EQ(bytes.error().port, "the line");
}

TEST_F(NetworkTransportTest, SaysWhatCannotBeReached) {
    const auto problemOf = [](NetworkLine line) {
        const auto opened = NetworkTransport(std::move(line), "it").open();
        return opened ? std::nullopt : std::optional(opened.error().problem);
    };
    server.stopListening();
    EXPECT_EQ(problemOf({NetworkLine::Protocol::Raw, "127.0.0.1", server.port()}), PortProblem::NotReached);
    EXPECT_EQ(problemOf({NetworkLine::Protocol::Raw, "no such host.invalid", 1}), PortProblem::HostNotFound);
    EXPECT_EQ(problemOf({}), PortProblem::NotANetworkLine);
}

/// Answers what the client says at the beginning, and sets each rate except 57 600, for which it has 38 400.
void serveRates(Server& server, int rates) {
    server.accept();
    (void)server.read(3 + 12 + 4 * 7);
    server.write({255, 253, 44});
    for (int i = 0; i < rates; ++i) {
        Bytes request = server.read(10);
        request[3] = 101;
        if (request[6] == 0xE1)  // 57 600 = 0xE100
            request[6] = 0x96;   // 38 400 = 0x9600
        server.write(request);
    }
}

TEST_F(NetworkTransportTest, SetsTheRateThroughRfc2217) {
    std::thread other([this] {
        serveRates(server, 3);
        server.write({1, 255, 255, 2});
    });
    NetworkTransport line = transport(NetworkLine::Protocol::Rfc2217, 115'200);
    ASSERT_TRUE(line.open()) << "at 115 200 to see that it can be set, and then at 19 200";
    EXPECT_FALSE(line.hasFixedRate());
    EXPECT_TRUE(line.setBaud(9'600));
    other.join();
    EXPECT_EQ(received(line), (Bytes{1, 255, 2}));
    ASSERT_TRUE(line.send(Bytes{0xAA, 0xFF}));
    EXPECT_EQ(server.read(3), (Bytes{0xAA, 0xFF, 0xFF}));
    EXPECT_EQ(line.onWire(Bytes{0xFF}, 19'200), (Bytes{255, 250, 44, 1, 0, 0, 0x4B, 0, 255, 240, 0xFF, 0xFF}))
        << "for the guardian: the rate may be another one at that moment";
    EXPECT_EQ(line.onWire({}, 19'200), Bytes{});
    line.discardInput();
    EXPECT_EQ(server.read(7), (Bytes{255, 250, 44, 12, 1, 255, 240}));
}

TEST_F(NetworkTransportTest, RefusesARateThatTheServerDoesNotHave) {
    std::thread other([this] { serveRates(server, 1); });
    const auto opened = transport(NetworkLine::Protocol::Rfc2217, 57'600).open();
    other.join();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().problem, PortProblem::RateNotPossible);
    EXPECT_EQ(opened.error().detail, "57600 Bd -> 38400 Bd");
}

TEST_F(NetworkTransportTest, RefusesAServerThatDoesNotLetThePortBeControlled) {
    std::thread other([this] {
        server.accept();
        server.write({255, 254, 44});
    });
    const auto opened = transport(NetworkLine::Protocol::Rfc2217).open();
    other.join();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().problem, PortProblem::NotRfc2217);
}

}  // namespace
}  // namespace nmc
