// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <variant>

#include "model/module/modulestate.h"

class QPainter;

namespace nmc {

/// Shows a state by shape first: by the mark of the activity, which is in a triangle for attention and in a
/// square for a fault. Activities that mean much the same share a mark.
void paintActivity(QPainter& painter, const QRectF& rect, Activity activity, const QPalette& palette);
/// Shows the severity of a message: a ringed i, a triangle or a square.
void paintSeverity(QPainter& painter, const QRectF& rect, Severity severity, const QPalette& palette);
/// Shows a status bit: a filled square when set, a hollow ring when clear, a dash when unknown.
void paintBit(QPainter& painter, const QRectF& rect, std::optional<bool> set, const QPalette& palette);

/// Shows an activity, a severity or a bit at the size of its font.
class GlyphLabel : public QWidget {
    Q_OBJECT

public:
    explicit GlyphLabel(QWidget* parent = nullptr) : QWidget(parent) {}
    void showActivity(Activity activity) { display(activity); }
    void showSeverity(Severity severity) { display(severity); }
    void showBit(std::optional<bool> set) { display(set); }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    using Bit = std::optional<bool>;
    using Shown = std::variant<std::monostate, Activity, Severity, Bit>;
    void display(const Shown& shown);

    Shown m_shown;
};

}  // namespace nmc
