// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QSettings>
#include <QTemporaryDir>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "sim/random.h"
#include "tests/monkey/controls.h"
#include "tests/monkey/oath.h"

class QWindow;

namespace nmc::monkey {

/// A user who presses, types and turns the wheel at random, with mouse and keys as they come from the system,
/// while anything may happen to line, modules and adapter. The same seed does the same.
class Monkey : public QObject {
public:
    explicit Monkey(std::uint64_t seed);
    ~Monkey() override;

    /// One act, and some time. Returns false if the oath is broken.
    bool act();
    [[nodiscard]] const Oath& oath() const { return *m_oath; }
    /// The last acts, for anyone who has to find out why.
    [[nodiscard]] std::string story() const;
    [[nodiscard]] unsigned motions() const { return m_motions + m_oath->motions(); }
    [[nodiscard]] unsigned stopsInMotion() const { return m_stopsInMotion + m_oath->stopsInMotion(); }
    [[nodiscard]] unsigned strikes() const { return m_strikes; }

private:
    void startProgram();
    void endProgram();
    void wait(Duration time);
    void note(const std::string& what);
    [[nodiscard]] std::size_t below(std::size_t limit) { return m_random.below(limit); }
    [[nodiscard]] Duration milliseconds(std::size_t from, std::size_t to);
    /// Delivers an input of the user.
    template <typename Deliver>
    void deliver(Deliver deliver);

    // What the user does.
    void actOnce();
    void press(const Spot& spot, Qt::MouseButton button, bool hold);
    void releaseMouse(bool elsewhere);
    void pressWhatMatters();
    void workPendant();
    [[nodiscard]] bool pendantIsOn() const;
    void makeReady();
    bool closeSomething();
    bool pressNamed(const QStringList& words);
    void pressAnything();
    void strikeKey(QKeyCombination key, bool hold = false);
    void strikeAnyKey();
    void strikeShortcut();
    void type();
    void turnWheel();
    void resizeWindow();
    void stopAll();
    void freeze();
    void befall();
    /// Qt waits for an answer in an event loop of its own.
    void inNestedLoop();
    [[nodiscard]] std::string state();

    sim::Random m_random;
    QTemporaryDir m_directory;
    QSettings m_settings;
    VirtualChain m_chain;
    std::unique_ptr<Composition> m_program;
    std::unique_ptr<Oath> m_oath;
    std::deque<std::string> m_story;
    unsigned m_acts = 0;
    unsigned m_motions = 0;
    unsigned m_stopsInMotion = 0;
    unsigned m_strikes = 0;
    unsigned m_faults = 0;  ///< since the simulator was told to forget them
    bool m_faultFree;
    int m_delivering = 0;
    QPointer<QWindow> m_pressedIn;
    QPoint m_pressedAt;
    bool m_pressedTab = false;
    std::optional<Qt::Key> m_keyDown;
};

}  // namespace nmc::monkey
