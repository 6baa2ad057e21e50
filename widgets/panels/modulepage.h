// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>

#include "widgets/panels/modulecontext.h"

class QHBoxLayout;
class QLayout;
class QScrollArea;
class QTabWidget;

namespace nmc {

class Command;
class HoldButton;

/// Everything that one module can be asked for: its head, which is always in view, the motions below at the
/// left, and pages beside them. Made for one module of one connection, and gone with it.
class ModulePage : public QWidget {
    Q_OBJECT

public:
    explicit ModulePage(const PanelView& view, QWidget* parent = nullptr);

    /// Emits nothing, except that a hold ends when its permission goes.
    void showModule(const PanelView& view) { m_context.show(view); }
    [[nodiscard]] ModuleContext& context() { return m_context; }
    /// Of all its boxes, in the order in which they stand.
    [[nodiscard]] QList<Command*> commands() const;
    /// Its button comes in sight, with its tool tip; `name` is that of the button.
    void showCommand(const QString& name);

    /// The one that moves it that way while it is held, which comes in sight; none: it has none.
    [[nodiscard]] HoldButton* holdButton(bool reverse);

    /// The page for tuning comes to the front, now and where little room brings the motions there.
    void setTuning(bool on);

    /// How much higher their room is than the motions need; below 0: not all of them are in view.
    [[nodiscard]] virtual int spareHeight() const;

signals:
    void responseWanted();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    /// The head above; motions at the left, the pages beside them: each scrolls for itself where there is
    /// little room, and where there is very little the motions are the first of the pages.
    void layOut(QWidget* head, QLayout* motions, QTabWidget* pages);

    ModuleContext m_context;

    /// Its tool tip says what it does, or why not.
    static void pointTo(QWidget& control);
    /// Brings the tab to the front that the box stands on.
    void reveal(const QWidget& box);
    /// The pages have so many pixels from now on; for those that leave out words where there are few.
    virtual void fitPages(int /*width*/) {}
    /// What is for tuning; nothing where there is none.
    virtual void revealTuning() {}

private:
    [[nodiscard]] int scrollBarWidth() const;
    [[nodiscard]] int columnsWidth() const;
    [[nodiscard]] int motionsWidth() const;
    [[nodiscard]] int pageWidth() const;
    void fit(int width);
    /// In operator mode, pages whose fields are not the operator's.
    void lockPages();

    std::optional<OperatorRights> m_lockedFor;
    QTabWidget* m_pages = nullptr;
    QScrollArea* m_motions = nullptr;
    QHBoxLayout* m_columns = nullptr;
    int m_columnWidth = 0;                  ///< pixels, below which the motions don't fit beside the pages
    int m_columnWish = 0;                   ///< pixels, from which on each row of them is one
    int m_pagesWish = 0;                    ///< pixels, from which on no page needs to be arranged otherwise
    std::map<const QWidget*, int> m_needs;  ///< pixels that a page needs to stand whole
    bool m_narrow = false;
    bool m_tuning = false;
};

}  // namespace nmc
