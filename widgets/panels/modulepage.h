// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>

#include "widgets/panels/modulecontext.h"

class QComboBox;
class QHBoxLayout;
class QLayout;
class QScrollArea;
class QTabWidget;

namespace nmc {

class Command;
class HoldButton;
class MoveByBox;

/// Page for everything that one module can do: its head, which is always visible, the motions below at the
/// left, and tabs beside them. Made for one module of one connection, and deleted with it.
class ModulePage : public QWidget {
    Q_OBJECT

public:
    ModulePage(const PanelView& view, Requests& requests);

    /// Emits nothing, except that a hold ends when it is no longer permitted.
    void showModule(const PanelView& view) { m_context.show(view); }
    [[nodiscard]] ModuleContext& context() { return m_context; }
    /// The commands of all its boxes, in the order in which they are shown.
    [[nodiscard]] QList<Command*> commands() const;
    /// Shows the button with the object name `name`, and its tool tip.
    void showCommand(const QString& name);

    /// Brings the hold button for this direction into view, and returns it; null if there is none.
    [[nodiscard]] HoldButton* holdButton(bool reverse);
    /// The box for steps, likewise.
    [[nodiscard]] MoveByBox* moveByBox();

    /// Brings the page for tuning to the front, now and whenever a lack of room would bring the motions
    /// there.
    void setTuning(bool on);

    /// Height in pixels that the motions leave unused; negative if not all of them fit without a scroll bar.
    [[nodiscard]] virtual int spareHeight() const;
    /// Hides the scroll bar of motions that fit without it. In the width that it leaves, their rows wrap and
    /// need it, so it would stay.
    void dropScrollBar();

signals:
    void responseWanted();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    /// Places the head above, the motions at the left and the pages beside them. Each scrolls by itself if
    /// there is little room; if there is very little, the motions become the first of the pages.
    void layOut(QWidget* head, QLayout* motions, QTabWidget* pages);

    ModuleContext m_context;

    /// Shows the tool tip of a control, which says what it does, or why it is not possible.
    static void pointTo(QWidget& control);
    /// Brings the tab that contains the box to the front.
    void reveal(const QWidget& box);
    /// Shows the controls for tuning, if there are any.
    virtual void revealTuning() {}

private:
    [[nodiscard]] int scrollBarWidth() const;
    [[nodiscard]] int columnsWidth() const;
    [[nodiscard]] int motionsWidth() const;
    [[nodiscard]] int pageWidth() const;
    void fit(int width);
    void offerPages();
    /// In operator mode, disables pages with fields that the operator may not use.
    void lockPages();

    std::optional<OperatorRights> m_lockedFor;
    QTabWidget* m_pages = nullptr;
    QComboBox* m_pageList = nullptr;  ///< instead of the tabs, if these do not fit
    QScrollArea* m_motions = nullptr;
    QHBoxLayout* m_columns = nullptr;
    int m_columnWidth = 0;                  ///< pixels; the least width of the motions
    int m_columnWish = 0;                   ///< pixels; width at which no row of the motions wraps
    int m_pagesWish = 0;                    ///< pixels; width at which no page has to be rearranged
    std::map<const QWidget*, int> m_needs;  ///< pixels; width that a page needs without wrapping
    bool m_narrow = false;
    bool m_tuning = false;
};

}  // namespace nmc
