// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>
#include <map>
#include <memory>
#include <optional>

#include "widgets/panels/panelview.h"

class QLabel;
class QScrollArea;

namespace nmc {

class GenericPanel;
class ModulePage;

/// The middle of the window: the page of the selected module, or what to do when there is none. A page is
/// built when its module is shown first, and belongs to this one module until the connection ends.
class ModulePanel : public QWidget {
    Q_OBJECT

public:
    explicit ModulePanel(QWidget* parent = nullptr);
    ~ModulePanel() override;

    /// Emits nothing, except that a hold ends when its module or its permission goes.
    void showModule(const PanelView& view);
    /// Builds the page of a module that has none yet, for when it is shown. False: it has one, or needs none.
    bool prepare(const PanelView& view);
    /// No module: `text` says why and what to do. `waiting`: one may come at any moment.
    void showNothing(const QString& text, bool waiting = false);
    /// The same, with a page of the caller's.
    void showInstead(QWidget& page);
    /// A new connection: nothing that was typed, found or remembered for the modules of the last one is left.
    void forgetModules();
    /// The chain is looked for anew: low speeds again.
    void resetSpeeds();
    void endHold();
    void setHoldInterval(int milliseconds);
    /// Into the fields of the PIC-SERVO that is shown; sends nothing.
    void stageGains(const servo::SetGain& gains);
    /// Below whichever page is shown, and scrolled where there is little room; null: nothing, and what was
    /// there is the caller's again.
    void setFoot(QWidget* foot);
    /// Of the module that is shown; none: it has no page.
    [[nodiscard]] ModulePage* page() const;
    /// One that has what this module's page has; none: it has no page.
    [[nodiscard]] const ModulePage* pageLike(const PanelView& view);

    // Of what is in sight.
    [[nodiscard]] QSize sizeHint() const override { return m_current->sizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return m_least; }

signals:
    /// Another page is in sight.
    void pageChanged();
    void responseWanted();
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// On press and every 100 ms while held.
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    /// The user changed what the panel knows of an axis; nothing is sent by that.
    void settingsEdited(nmc::ModuleIndex module, const nmc::AxisSettings& settings);

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] ModulePage& pageOf(const PanelView& view);
    [[nodiscard]] std::unique_ptr<ModulePage> build(const PanelView& view);
    void bringUp(QWidget* page);
    /// What is in sight fills this. A layout would have the whole window laid out anew for each page, though
    /// pages need the same room.
    void fill();

    struct Page {
        // Another module at the same place has a page of its own.
        BusAddress address;
        ModuleIdentity identity;
        std::unique_ptr<ModulePage> widget{};
    };
    QLabel* m_empty;
    GenericPanel* m_generic;
    QWidget* m_current;
    QSize m_least;
    QPointer<QWidget> m_foot;
    QScrollArea* m_footPlace = nullptr;
    /// Those that are not shown are windows of their own, never seen: in this one there is one control of a
    /// name, and its focus chain stays short.
    std::map<ModuleIndex, Page> m_pages;
    std::optional<int> m_holdInterval;
};

}  // namespace nmc
