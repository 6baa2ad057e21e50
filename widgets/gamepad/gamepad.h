// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

struct _SDL_GameController;

namespace nmc {

/// A gamepad used as a pendant: a shoulder button enables, the left stick or the D-pad selects the direction,
/// and B (○) stops all. The first one that is plugged in is used. Read on the GUI thread, and only while
/// switched on; otherwise nothing is open and nothing runs.
class Gamepad : public QObject {
    Q_OBJECT

public:
    explicit Gamepad(QObject* parent);
    ~Gamepad() override;

    void setOn(bool on);
    [[nodiscard]] bool isThere() const { return m_pad != nullptr; }

signals:
    /// isThere() has changed.
    void changed();
    /// The stick or the D-pad has left its centre while a shoulder button was held. What was held before the
    /// pad was found, or before the shoulder button, does not count as a press.
    void pressed(bool reverse);
    /// The direction or the shoulder button has been released, the direction has changed, B was pressed, or
    /// the pad is gone or switched off.
    void released();
    void stopPressed();

private:
    enum class Direction { None, Forward, Reverse };
    struct Hands {
        bool enables = false;
        Direction direction = Direction::None;
        bool stops = false;
    };
    struct Closer {
        void operator()(_SDL_GameController* pad) const;
    };
    void look();
    void find();
    void follow(const Hands& now);
    void release();
    [[nodiscard]] Hands read() const;
    [[nodiscard]] Direction direction() const;

    std::unique_ptr<_SDL_GameController, Closer> m_pad;
    QTimer m_timer;
    Hands m_hands;
    bool m_moves = false;  ///< pressed() was emitted, and released() not yet
    bool m_open = false;   ///< SDL is open
};

}  // namespace nmc
