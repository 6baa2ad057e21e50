// SPDX-License-Identifier: GPL-3.0-or-later
// Ten minutes of a host that does everything it may, and much that it should not. Its own books, kept only
// from the bytes on the line, are compared with `stats` and `state`.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "sim/control.h"
#include "sim/random.h"
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

constexpr unsigned kEveryone = 0xFF;
constexpr unsigned kInputs = 0x0C;  // I/O Control: both limit pins are inputs

/// DS-V 5.1 and DS-S 5.1, by command code; empty: not on this chip.
constexpr std::array<std::array<const char*, 16>, 2> kNames{{
    {"reset_position", "set_address", "define_status", "read_status", "load_trajectory", "start_motion",
     "set_gain", "stop_motor", "io_control", "set_homing", "set_baud", "clear_sticky_bits", "save_as_home",
     "", "nop", "hard_reset"},
    {"reset_position", "set_address", "define_status", "read_status", "load_trajectory", "start_motion",
     "set_parameters", "stop_motor", "set_outputs", "set_homing", "set_baud", "", "save_as_home", "", "nop",
     "hard_reset"},
}};

struct Rate {
    std::uint32_t baud;
    std::uint8_t code;
};
constexpr Rate kPowerUp{19'200, 63};
constexpr std::array<Rate, 4> kRates{{{9'600, 129}, {19'200, 64}, {57'600, 21}, {115'200, 10}}};

/// What the host knows about a module.
struct Book {
    bool isStep = false;
    unsigned version = 0;

    unsigned address = 0;  ///< 0: has none
    unsigned group = kEveryone;
    bool leader = false;
    unsigned code = kPowerUp.code;
    unsigned items = 0;
    std::optional<Bytes> gains;  ///< when they were in range
    unsigned pinControl = kInputs;
    unsigned outputs = 0x10;
    std::optional<std::int32_t> home = 0;  ///< empty: a home search may have changed it

    // Inputs from outside, which no reset changes.
    std::map<std::string, unsigned> set;

    std::map<std::string, unsigned> executed;
    unsigned replies = 0;
    unsigned dropped = 0;
    unsigned wrongSums = 0;

    void reset() {
        Book fresh;
        fresh.isStep = isStep;
        fresh.version = version;
        fresh.set = set;
        fresh.executed = executed;
        fresh.replies = replies;
        fresh.dropped = dropped;
        fresh.wrongSums = wrongSums;
        *this = fresh;
    }
};

std::size_t sizeOfItems(unsigned items) {
    constexpr std::array<std::size_t, 6> kSizes{4, 1, 2, 1, 4, 2};
    std::size_t size = 0;
    for (unsigned i = 0; i < kSizes.size(); ++i)
        size += (items >> i & 1U) != 0 ? kSizes[i] : 0;
    return size;
}

/// A status packet; items that were not sent are absent.
struct Reply {
    unsigned status = 0;
    std::array<std::optional<std::uint32_t>, 6> item;

    Reply(const Bytes& bytes, unsigned items) : status(bytes.at(0)) {
        std::size_t at = 1;
        for (unsigned i = 0; i < item.size(); ++i) {
            if ((items >> i & 1U) == 0)
                continue;
            std::uint32_t value = 0;
            for (std::size_t k = 0; k < sizeOfItems(1U << i); ++k)
                value |= std::uint32_t{bytes.at(at++)} << (8 * k);
            item[i] = value;
        }
    }
    [[nodiscard]] bool bit(unsigned number) const { return (status >> number & 1U) != 0; }
    [[nodiscard]] std::optional<std::int32_t> home() const {
        return item[4] ? std::optional(static_cast<std::int32_t>(*item[4])) : std::nullopt;
    }
};

class Session {
public:
    explicit Session(std::uint64_t seed)
        : m_random(seed), m_chain(parseChain("servo,servo@2,step,servo@1").value(), optionsOf(seed)) {
        const std::array<unsigned, 4> versions{4, 2, 1, 1};
        for (std::size_t i = 0; i < m_books.size(); ++i) {
            m_books[i].isStep = i == 2;
            m_books[i].version = versions[i];
        }
        m_books[2].set = {{"estop", 0},  {"in1", 0},    {"in2", 0},   {"home_switch", 0},
                          {"limit1", 0}, {"limit2", 0}, {"power", 1}, {"analog", 255}};
        for (const std::size_t i : {0U, 1U, 3U})
            m_books[i].set = {{"limit1", 0}, {"limit2", 0}, {"power", 1}};
    }

    void run(Duration time) {
        const TimePoint end = m_now + time;
        wait(milliseconds(20));
        enumerate();
        while (m_now < end && !testing::Test::HasFailure()) {
            const TimePoint checkpoint = std::min(end, m_now + seconds(60));
            while (m_now < checkpoint && !testing::Test::HasFailure())
                doSomething();
            check();
        }
    }

private:
    static ChainOptions optionsOf(std::uint64_t seed) {
        ChainOptions options;
        options.seed = seed;
        return options;
    }

    unsigned below(unsigned limit) { return static_cast<unsigned>(m_random.below(limit)); }
    Bytes randomBytes(std::size_t count) {
        Bytes bytes;
        for (std::size_t i = 0; i < count; ++i)
            bytes.push_back(static_cast<std::uint8_t>(below(256)));
        return bytes;
    }
    Book& anyModule() { return m_books[m_random.below(m_books.size())]; }

    // ---- The wire ----

    void take() {
        for (const HostByte& byte : m_chain.takeHostBytes()) {
            m_heard.push_back(byte.value);
            ++m_bytesOut;
        }
    }
    void wait(Duration time) {
        m_now += time;
        m_chain.advanceTo(m_now);
        take();
        EXPECT_TRUE(m_heard.empty()) << "no module was queried";
        m_heard.clear();
    }
    void send(const Bytes& bytes) {
        m_bytesIn += bytes.size();
        m_chain.hostSends(bytes, m_now);
    }
    /// Receives until the line is silent.
    Bytes hear() {
        while (const auto next = m_chain.nextEvent()) {
            m_now = *next;
            m_chain.advanceTo(m_now);
            take();
        }
        return std::exchange(m_heard, {});
    }
    nlohmann::json say(const std::string& line) {
        return nlohmann::json::parse(handleControlLine(m_chain, line, m_now));
    }

    // ---- Commands ----

    /// A module without an address is awake once its neighbour on the side away from the host has one.
    [[nodiscard]] bool isAwake(const Book& book) const {
        return book.address != 0 || &book == m_books.data() || (&book)[-1].address != 0;
    }
    static bool isFor(const Book& book, unsigned address, unsigned command, bool good) {
        const bool resetsAll = good && book.isStep && address == kEveryone && (command & 0x0FU) == 0x0F;
        return address == book.address || address == book.group || resetsAll;
    }

    /// Sends one command, waits for its end, and enters it in the books.
    std::optional<Reply> command(unsigned address, unsigned command, const Bytes& data = {},
                                 bool good = true) {
        Bytes bytes = packet(address, command, data);
        if (!good)
            bytes.back() = static_cast<std::uint8_t>(bytes.back() + 1 + below(255));
        send(bytes);
        return finish(address, command, data, good);
    }

    std::optional<Reply> finish(unsigned address, unsigned command, const Bytes& data, bool good) {
        std::vector<Book*> hearers;
        for (Book& book : m_books)
            if (isAwake(book) && isFor(book, address, command, good))
                hearers.push_back(&book);
        Book* answering = nullptr;
        for (Book* book : hearers) {
            if (address == book->address || (address == book->group && book->leader))
                answering = book;
            if (good)
                execute(*book, command & 0x0FU, data);
            else
                ++book->wrongSums;
        }
        const bool isReset = good && (command & 0x0FU) == 0x0F;
        const Bytes bytes = hear();
        if (answering == nullptr || isReset) {
            EXPECT_TRUE(bytes.empty()) << "to " << address << ": " << command;
            return std::nullopt;
        }
        const unsigned items = good && (command & 0x0FU) == 0x03 ? data[0] : answering->items;
        EXPECT_EQ(bytes.size(), 2 + sizeOfItems(items)) << "to " << address << ": " << command;
        if (bytes.size() != 2 + sizeOfItems(items))
            return std::nullopt;
        EXPECT_EQ(std::accumulate(bytes.begin(), bytes.end() - 1, 0U) & 0xFFU, bytes.back());
        ++answering->replies;
        const Reply reply(bytes, items);
        EXPECT_EQ(reply.bit(1), !good);
        look(*answering, reply);
        // Position and home in one reply are of the same instant.
        if (good && (command & 0x0FU) == 0x0C && reply.item[0] && reply.item[4]) {
            EXPECT_EQ(reply.item[0], reply.item[4]);
        }
        if (good && (command & 0x0FU) == 0x00 && reply.item[0] && !answering->isStep) {
            EXPECT_EQ(*reply.item[0], 0U);
        }
        return reply;
    }

    /// Checks what is the same in every reply.
    void look(const Book& book, const Reply& reply) {
        EXPECT_EQ(reply.bit(3), book.set.at("power") != 0);
        if (!book.isStep) {
            EXPECT_EQ(reply.bit(5), pin(book, 0));
            EXPECT_EQ(reply.bit(6), pin(book, 1));
        }
        if (book.isStep && reply.item[3]) {
            EXPECT_EQ(*reply.item[3], inputs(book));
        }
        if (book.set.contains("analog") && reply.item[1]) {
            EXPECT_EQ(*reply.item[1], book.set.at("analog"));
        }
        if (reply.item[5]) {
            EXPECT_EQ(*reply.item[5], (book.isStep ? 3U : 0U) | book.version << 8U);
        }
        if (book.home && reply.home()) {
            EXPECT_EQ(reply.home(), book.home);
        }
    }
    static bool pin(const Book& book, unsigned number) {
        if ((book.pinControl >> (2 + number) & 1U) == 0)
            return (book.pinControl >> number & 1U) != 0;
        return book.set.at(number == 0 ? "limit1" : "limit2") != 0;
    }
    static unsigned inputs(const Book& book) {
        unsigned byte = 0;
        unsigned bit = 0;
        for (const char* name : {"estop", "in1", "in2", "limit1", "limit2", "home_switch"})
            byte |= book.set.at(name) << bit++;
        return byte;
    }

    static void execute(Book& book, unsigned code, const Bytes& data) {
        ++book.executed[kNames[book.isStep ? 1 : 0][code]];
        switch (code) {
            case 0x1:
                book.address = data[0];
                book.group = data[1] | 0x80U;
                book.leader = data[1] < 0x80;
                return;
            case 0x2:
                book.items = data[0];
                return;
            case 0x6:
                book.gains.reset();
                if (!book.isStep && data.size() >= 14 && gainsAreLegal(data))
                    book.gains = data;
                return;
            case 0x8:
                if (book.isStep)
                    book.outputs = data[0] & 0x1FU;
                else
                    book.pinControl = data[0];
                return;
            case 0x9:
                book.home.reset();
                return;
            case 0xA:
                book.code = data[0];
                return;
            case 0xC:
                book.home.reset();  // unknown until a reply contains it
                return;
            case 0xF:
                book.reset();
                return;
            default:
                return;
        }
    }
    static bool gainsAreLegal(const Bytes& data) {
        return data[1] < 0x80 && data[3] < 0x80 && data[5] < 0x80 && data[7] < 0x80 && data[11] < 0x40 &&
               data[12] > 0;
    }

    // ---- What the host does ----

    void enumerate() {
        for (Book& book : m_books)
            if (book.address == 0)
                giveAddress(book);
    }
    void giveAddress(Book& book) {
        unsigned address = 0;
        do
            address = 1 + below(0x7F);
        while (
            std::any_of(m_books.begin(), m_books.end(), [&](const Book& b) { return b.address == address; }));
        command(book.address, 0x21, groupData(book, address));
    }
    /// FF twice as often as the two other groups; a leader only where there is none.
    Bytes groupData(const Book& book, unsigned address) {
        const unsigned group = std::array{0xFFU, 0xFFU, 0x81U, 0xA0U}[below(4)];
        const bool isLed = std::any_of(m_books.begin(), m_books.end(), [&](const Book& other) {
            return &other != &book && other.leader && other.group == group;
        });
        const unsigned leads = !isLed && below(2) == 0 ? 0x80U : 0U;
        return {static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(group & ~leads)};
    }

    void changeRate(const Rate& rate) {
        for (Book& book : m_books)
            if (book.group != kEveryone)
                command(book.address, 0x21, {static_cast<std::uint8_t>(book.address), kEveryone});
        // A leader answers at the new rate.
        send(packet(kEveryone, 0x1A, {rate.code}));
        m_chain.setHostBaud(rate.baud);
        m_rate = rate;
        finish(kEveryone, 0x1A, {rate.code}, true);
    }

    /// Resets one module or all; at a rate other than the power-up rate all, before the first one listens
    /// again.
    void reset() {
        Book& one = anyModule();
        if (m_rate.baud == kPowerUp.baud && below(3) > 0) {
            powerCycleOr([&] { command(one.address, 0x0F); }, one);
        } else {
            if (m_rate.baud < kPowerUp.baud)
                changeRate(kPowerUp);  // otherwise the first would listen again before the last is reset
            const bool reachesAll = std::all_of(m_books.begin(), m_books.end(), [](const Book& b) {
                return b.group == kEveryone || b.isStep;
            });
            if (reachesAll && below(2) == 0) {
                command(kEveryone, 0x0F);
            } else {
                for (Book& book : m_books)
                    command(book.address, 0x0F);
            }
            m_rate = kPowerUp;
            m_chain.setHostBaud(m_rate.baud);
        }
        wait(milliseconds(20));
        enumerate();
    }
    template <typename Reset>
    void powerCycleOr(Reset byCommand, Book& book) {
        if (below(2) == 0)
            return byCommand();
        EXPECT_EQ(say("power-cycle " + std::to_string(&book - m_books.data() + 1)),
                  nlohmann::json({{"ok", true}}));
        book.reset();
    }

    void changeTheWorld() {
        Book& book = anyModule();
        std::vector<std::string> names;
        for (const auto& [name, value] : book.set)
            names.push_back(name);
        names.push_back("analog");
        const std::string& name = names[below(static_cast<unsigned>(names.size()))];
        const unsigned value = below(name == "analog" ? 256 : 2);
        const auto answer = say("set " + std::to_string(&book - m_books.data() + 1) + " " + name + " " +
                                std::to_string(value));
        EXPECT_TRUE(answer.contains("ok")) << answer;
        book.set[name] = value;
    }

    /// A reply that is cut short by a null: the command counts as executed, but not as answered.
    void cut() {
        Book& book = anyModule();
        ++book.executed["read_status"];
        send(packet(book.address, 0x13, {0x3F}));
        while (m_heard.empty()) {
            m_now = m_chain.nextEvent().value();
            m_chain.advanceTo(m_now);
            take();
        }
        send({0});
        hear();
        ++book.dropped;
    }

    /// A packet that is cut off; nulls replace what is missing, and one of them is taken for the sum.
    void tear() {
        const unsigned address = anyModule().address;
        const unsigned length = below(15);
        const Bytes data = randomBytes(length);
        const unsigned kept = below(length + 1);
        const Bytes whole = packet(address, length << 4U | 0x0EU, data);
        send(Bytes(whole.begin(), whole.begin() + 3 + kept));
        EXPECT_TRUE(hear().empty());
        wait(milliseconds(below(50)));
        send(Bytes(length - kept + 1, 0));
        unsigned sum = address + (length << 4U | 0x0EU);
        for (unsigned i = 0; i < kept; ++i)
            sum += data[i];
        finish(address, length << 4U | 0x0EU, data, (sum & 0xFFU) == 0);
    }

    void doSomething() {
        const unsigned what = below(1'000);
        if (what < 4)
            changeRate(kRates[m_random.below(kRates.size())]);
        else if (what < 8)
            reset();
        else if (what < 40)
            changeTheWorld();
        else if (what < 60)
            cut();
        else if (what < 80)
            tear();
        else if (what < 120)
            sendNoise();
        else
            randomCommand();
        static constexpr std::array kPauses{2U, 5U, 50U, 100U, 300U};
        const auto pause = below(1'000);
        wait(microseconds(600 + pause * kPauses[below(kPauses.size())]));
    }

    /// Sends anything that is not a header.
    void sendNoise() {
        Bytes noise = below(2) == 0 ? Bytes(1 + below(30), 0) : randomBytes(1 + below(20));
        std::replace(noise.begin(), noise.end(), std::uint8_t{0xAA}, std::uint8_t{0xAB});
        send(noise);
        EXPECT_TRUE(hear().empty());
    }

    void randomCommand() {
        const Book& book = anyModule();
        const unsigned to = below(10);
        const unsigned address = to == 0   ? 0x80 + below(0x80)
                                 : to == 1 ? below(0x80)
                                 : to < 4  ? book.group
                                           : book.address;
        const bool good = below(20) > 0;
        const unsigned code = below(16);
        switch (code) {
            case 0x1:
                if (address == book.address)
                    command(address, 0x21, groupData(book, address), good);
                return;
            case 0x2:
            case 0x3:
                command(address, 0x10 | code, {static_cast<std::uint8_t>(below(0x40))}, good);
                return;
            case 0x4:
                return loadTrajectory(book, address, good);
            case 0x6:
                return setGain(book, address, good);
            case 0x7: {
                const bool here = !book.isStep && below(4) == 0;
                Bytes data = randomBytes(here ? 5 : 1);
                data[0] = static_cast<std::uint8_t>(below(8) == 0 ? data[0]
                                                    : here        ? 0x11
                                                                  : 1U | 1U << below(4));
                command(address, here ? 0x57 : 0x17, data, good);
                return;
            }
            case 0x8:
            case 0x9:
                command(address, 0x10 | code, randomBytes(1), good);
                return;
            case 0xA:
            case 0xF:
            case 0xD:
                return;  // done by changeRate() and reset(); D is not in the data sheets
            case 0xB:
                if (address == book.address && !book.isStep)
                    command(address, 0x0B, {}, good);
                return;
            default:
                command(address, code, {}, good);
        }
    }

    /// Mostly loads that make a motor move, and sometimes arbitrary bytes.
    void loadTrajectory(const Book& book, unsigned address, bool good) {
        if (below(4) == 0) {
            const Bytes data = randomBytes(1 + below(14));
            command(address, static_cast<unsigned>(data.size()) << 4U | 4U, data, good);
            return;
        }
        Bytes data{static_cast<std::uint8_t>(below(256))};
        const unsigned control = data[0];
        const auto maybe = [&](unsigned bit, std::uint32_t value, int count) {
            if ((control >> bit & 1U) != 0)
                append(data, value, count);
        };
        maybe(0, below(20'000) - 10'000, 4);
        maybe(1, book.isStep ? 1 + below(250) : below(10 * 65'536), book.isStep ? 1 : 4);
        maybe(2, book.isStep ? 1 + below(255) : below(65'536), book.isStep ? 1 : 4);
        if (book.isStep) {
            const auto low = 1 + below(65'452);
            maybe(3, low | (1 + below(250)) << 16U, 3);
        } else {
            maybe(3, below(256), 1);
        }
        command(address, static_cast<unsigned>(data.size()) << 4U | 4U, data, good);
    }

    void setGain(const Book& book, unsigned address, bool good) {
        Bytes data = randomBytes(book.isStep ? 5 : 13 + below(3));
        if (!book.isStep && below(2) == 0)
            data = gainData(200, 2000, 20, 200, 255, 0, 0x3FFF, 1, below(20));
        if (below(20) == 0)
            data.resize(below(16));
        command(address, static_cast<unsigned>(data.size()) << 4U | 6U, data, good);
    }

    // ---- Checkpoints ----

    void check() {
        // Stops all motors, because otherwise the reply and the true state would be of different instants.
        for (Book& book : m_books) {
            command(book.address, 0x19, {0x00});
            command(book.address, 0x17, {static_cast<std::uint8_t>(book.isStep ? 0x04 : 0x02)});
        }
        wait(seconds(5));
        for (std::size_t i = 0; i < m_books.size(); ++i)
            checkState(m_books[i], i + 1);
        checkStats();
    }

    void checkState(Book& book, std::size_t number) {
        const auto reply = command(book.address, 0x13, {0x3F});
        const auto state = say("state " + std::to_string(number));
        SCOPED_TRACE(state.dump());
        ASSERT_TRUE(reply);
        EXPECT_EQ(state["address"], book.address);
        EXPECT_EQ(state["group"], book.group);
        EXPECT_EQ(state["leader"], book.leader);
        EXPECT_EQ(state["baud"], std::lround(1'250'000.0 / (book.code + 1)));
        EXPECT_EQ(state["version"], book.version);
        EXPECT_EQ(state["position"], static_cast<std::int32_t>(*reply->item[0]));
        EXPECT_EQ(state["analog"], *reply->item[1]);
        EXPECT_EQ(state["home"], *reply->home());
        EXPECT_EQ(state["power"], reply->bit(3));
        if (book.isStep) {
            EXPECT_EQ(state["timer_count"], *reply->item[2]);
            EXPECT_EQ(state["outputs"], book.outputs);
            EXPECT_FALSE(reply->bit(0));
            EXPECT_FALSE(state["moving"]);
        } else {
            EXPECT_EQ(*reply->item[2], 0U);
            EXPECT_EQ(state["velocity"], 0.0);
            EXPECT_EQ(state["servo_on"], (*reply->item[3] & 0x04U) != 0);
            EXPECT_FALSE(state["servo_on"]);
            EXPECT_EQ(state["index"], (*reply->item[3] & 0x01U) == 0);
            EXPECT_EQ(state["limit1"], pin(book, 0));
            EXPECT_EQ(state["limit2"], pin(book, 1));
            if (book.gains)
                checkGains(book, state["gains"]);
        }
        // From here on, home is known again, because no search is in progress.
        book.home = reply->home();
    }

    static void checkGains(const Book& book, const nlohmann::json& gains) {
        const Bytes& d = *book.gains;
        const auto word = [&d](std::size_t at) { return d[at] | d[at + 1] << 8U; };
        EXPECT_EQ(gains["kp"], word(0));
        EXPECT_EQ(gains["kd"], word(2));
        EXPECT_EQ(gains["ki"], word(4));
        EXPECT_EQ(gains["il"], word(6));
        EXPECT_EQ(gains["ol"], d[8]);
        EXPECT_EQ(gains["cl"], d[9]);
        EXPECT_EQ(gains["el"], word(10));
        EXPECT_EQ(gains["sr"], d[12]);
        EXPECT_EQ(gains["db"], book.version >= 4 ? d[13] : 0) << "version 4 only";
    }

    void checkStats() {
        const auto stats = say("stats");
        unsigned replies = 0;
        for (std::size_t i = 0; i < m_books.size(); ++i) {
            const Book& book = m_books[i];
            const auto& module = stats["modules"][i];
            EXPECT_EQ(module["executed"], nlohmann::json(book.executed)) << "module " << i + 1;
            EXPECT_EQ(module["replies"], book.replies);
            EXPECT_EQ(module["replies_dropped"], book.dropped);
            EXPECT_EQ(module["checksum_errors"], book.wrongSums);
            EXPECT_EQ(module["bytes_garbled"], 0);
            replies += book.replies;
        }
        EXPECT_EQ(stats["exchanges"], replies);
        EXPECT_EQ(stats["bytes_in"], m_bytesIn);
        EXPECT_EQ(stats["bytes_out"], m_bytesOut);
        EXPECT_EQ(stats["bytes_lost"], 0);
        for (const auto& violation : stats["violations"])
            EXPECT_THAT(violation["kind"].get<std::string>(),
                        testing::AllOf(testing::Ne("command_in_flight"), testing::Ne("command_overwritten"),
                                       testing::Ne("reply_collision"), testing::Ne("set_baud_single")));
    }

    Random m_random;
    Chain m_chain;
    TimePoint m_now;
    Rate m_rate = kPowerUp;
    std::array<Book, 4> m_books;
    Bytes m_heard;
    std::size_t m_bytesIn = 0;
    std::size_t m_bytesOut = 0;
};

class RandomSession : public testing::TestWithParam<unsigned> {};

TEST_P(RandomSession, OfTenMinutesAgreesWithStatsAndState) {
    constexpr unsigned kSeeds = 25;
    for (unsigned seed = GetParam() * kSeeds; seed < (GetParam() + 1) * kSeeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Session(seed).run(minutes(10));
        if (HasFailure())
            return;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSession, testing::Range(0U, 4U));

}  // namespace
}  // namespace nmc::sim::test
