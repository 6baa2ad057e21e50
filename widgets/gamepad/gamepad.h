// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>

struct _SDL_GameController;

namespace nmc {

/// A gamepad, held as a pendant is: a shoulder button enables, the left stick or the cross chooses the way,
/// and B (○) stops all. The first one that is plugged in counts. Read on the GUI thread, and only while on();
/// otherwise nothing is open and nothing runs.
class Gamepad : public QObject {
    Q_OBJECT

public:
    explicit Gamepad(QObject* parent);
    ~Gamepad() override;

    void setOn(bool on);
    [[nodiscard]] bool isThere() const { return m_pad != nullptr; }

signals:
    /// isThere().
    void changed();
    /// The stick has left its middle while a shoulder button was held. Nothing that was held before the pad
    /// was found, or before the shoulder button, is a press.
    void pressed(bool reverse);
    /// One of the two has been released, the stick goes the other way, or the pad is gone.
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
    bool m_moves = false;  ///< pressed() was told, and not yet released()
    bool m_open = false;   ///< SDL is
};

}  // namespace nmc
