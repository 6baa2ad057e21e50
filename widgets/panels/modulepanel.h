// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>
#include <map>
#include <memory>

#include "widgets/panels/panelview.h"

class QLabel;
class QScrollArea;

namespace nmc {

class GenericPanel;
class ModulePage;
class Requests;

/// The middle of the window: the page of the selected module, or what to do if there is none. A page is built
/// when its module is first shown, or before that by prepare(), and belongs to this one module until the
/// connection ends.
class ModulePanel : public QWidget {
    Q_OBJECT

public:
    explicit ModulePanel(Requests& requests, QWidget* parent = nullptr);
    ~ModulePanel() override;

    /// Emits nothing, except that a hold ends when its module disappears or it is no longer permitted.
    void showModule(const PanelView& view);
    /// Builds the page of a module before it is shown. Returns false if it has one already, or needs none.
    bool prepare(const PanelView& view);
    /// Discards the page of another module than the one that is at this place now: its dialogs may still be
    /// open, and would change the settings of that one. One whose type was not reported may be the same.
    void dropReplaced(const bus::ModuleInfo& info);
    /// The page of a module that is not shown learns the state of its axis: its dialogs may still be open.
    void keepUpToDate(const PanelView& view);
    /// Shows that there is no module: `text` says why and what to do. `waiting`: one may appear at any
    /// moment.
    void showNothing(const QString& text, bool waiting = false);
    /// Shows a page of the caller instead of a module.
    void showInstead(QWidget& page);
    /// For a new connection: discards everything that was typed, found or remembered for the modules of the
    /// last one.
    void forgetModules();
    /// The chain is searched for again: speeds are low again.
    void resetSpeeds();
    void endHold();
    /// Fills the gains into the fields of the PIC-SERVO that is shown; sends nothing.
    void stageGains(const servo::SetGain& gains);
    /// Shows `foot` below any page that is shown, scrolled if there is little room. Null removes it; what was
    /// there then belongs to the caller again.
    void setFoot(QWidget* foot);
    /// The page of the module that is shown; null if it has none.
    [[nodiscard]] ModulePage* page() const;
    /// A page with the same content as the page of this module; null if that has none.
    [[nodiscard]] const ModulePage* pageLike(const PanelView& view);

    // The sizes of what is visible.
    [[nodiscard]] QSize sizeHint() const override { return m_current->sizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return m_least; }

signals:
    /// Another page is visible.
    void pageChanged();
    void responseWanted();

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] ModulePage& pageOf(const PanelView& view);
    [[nodiscard]] std::unique_ptr<ModulePage> build(const PanelView& view);
    void bringUp(QWidget* page);
    /// Makes the visible page fill the panel. A layout would lay out the whole window again for each page,
    /// although pages need the same room.
    void fill();

    struct Page {
        // Another module at the same place gets a page of its own.
        BusAddress address;
        ModuleIdentity identity;
        std::unique_ptr<ModulePage> widget{};
    };
    Requests& m_requests;
    QLabel* m_empty;
    GenericPanel* m_generic;
    QWidget* m_current;
    QSize m_least;
    QPointer<QWidget> m_foot;
    QScrollArea* m_footPlace = nullptr;
    /// Pages that are not shown are separate windows that are never visible, so that each object name is
    /// unique in this one, and its focus chain stays short.
    std::map<ModuleIndex, Page> m_pages;
};

}  // namespace nmc
