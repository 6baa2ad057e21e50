// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "model/module/modulestate.h"

class QPainter;

namespace nmc {

/// State by shape first: every activity has a mark of its own; attention stands in a triangle, a fault in a
/// square.
void paintActivity(QPainter& painter, const QRectF& rect, Activity activity, const QPalette& palette);
/// The sign of a message: a ringed i, a triangle, a square.
void paintSeverity(QPainter& painter, const QRectF& rect, Severity severity, const QPalette& palette);
/// A status bit: a filled square when set, a hollow ring when clear, a dash when unknown.
void paintBit(QPainter& painter, const QRectF& rect, std::optional<bool> set, const QPalette& palette);

/// Shows one of the above at the size of its font.
class GlyphLabel : public QWidget {
    Q_OBJECT

public:
    explicit GlyphLabel(QWidget* parent = nullptr) : QWidget(parent) {}
    void showActivity(Activity activity);
    void showSeverity(Severity severity);
    void showBit(std::optional<bool> set);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    enum class Kind : std::uint8_t { None, Activity, Severity, Bit };
    Kind m_kind = Kind::None;
    Activity m_activity = Activity::Unknown;
    Severity m_severity = Severity::Normal;
    std::optional<bool> m_bit;
};

}  // namespace nmc
