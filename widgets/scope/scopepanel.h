// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "base/strong.h"
#include "model/series.h"

class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace nmc {

class ScopePlot;

/// The scope of the selected module: strips that share one time axis. Rolls, or stands while paused. The
/// charts are built when the panel is first seen, and painted only while it is.
class ScopePanel : public QWidget {
    Q_OBJECT

public:
    explicit ScopePanel(QWidget* parent = nullptr);

    /// At most 60 times a second. Nothing is kept of `history` but what this frame shows.
    void showHistory(ModuleIndex module, const ModuleHistory& history, TimePoint now);
    /// A new connection, or none: time starts again.
    void forget();

    [[nodiscard]] bool paused() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void align();
    void measureRates(const ModuleHistory& history, TimePoint now);
    [[nodiscard]] double windowSeconds() const;

    QVBoxLayout* m_layout;
    QComboBox* m_window;
    QToolButton* m_pause;
    QLabel* m_which;
    ScopePlot* m_position = nullptr;
    ScopePlot* m_error = nullptr;
    std::optional<ModuleIndex> m_module;
    std::optional<TimePoint> m_origin;
    std::optional<TimePoint> m_ratesAt;
};

}  // namespace nmc
