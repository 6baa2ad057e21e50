// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/scope/scopetrigger.h"
#include "widgets/scope/scoperecord.h"
#include "widgets/scope/scopesetup.h"

class QBoxLayout;
class QMenu;
class QVBoxLayout;

namespace nmc {

class CursorPanel;
class ScopeBar;
class ScopeFiles;
class ScopeStrips;
class TriggerControl;
class Underlay;

/// The scope: its tool bar, the strips, and what cursors read. Rolls with the present, stands while paused,
/// or shows a record that is over. The charts are built when the panel is first seen, and painted only while
/// it is.
class ScopePanel : public QWidget {
    Q_OBJECT

public:
    explicit ScopePanel(QWidget* parent = nullptr);
    ~ScopePanel() override;

    /// How to read the live samples, and whose are "the selected module's".
    void showModules(std::vector<ScopeModule> modules, std::optional<ModuleIndex> selected);
    [[nodiscard]] const std::vector<ScopeModule>& modules() const { return m_modules; }
    /// At most 60 times a second. Nothing is kept of `history` but what this frame shows.
    void showHistory(const History& history, TimePoint now);
    /// Instead of what is live, until backToLive().
    void showRecord(std::shared_ptr<const ScopeRecord> record);
    void backToLive();
    /// Below the live traces, until removeUnder() or another one.
    void showUnder(std::shared_ptr<const ScopeRecord> record);
    void removeUnder();
    [[nodiscard]] bool showsRecord() const { return m_record != nullptr; }
    /// What the user has arranged.
    void setSetup(const ScopeSetup& setup);
    [[nodiscard]] const ScopeSetup& setup() const { return m_setup; }
    [[nodiscard]] bool paused() const;
    /// Where the live samples come from.
    void showSession(const QString& port, bool simulated);
    [[nodiscard]] ScopeFiles& files() { return *m_files; }

signals:
    void setupChanged(const nmc::ScopeSetup& setup);
    /// Something else is to be seen: a call of showHistory() soon, though nothing may have come in.
    void frameWanted();

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void connectBar();
    void addFileButtons();
    void buildStrips();
    void buildReadings();
    void placeReadings();
    void move(const std::function<void(ScopeStrips&)>& how);
    void setPaused(bool paused);
    void setWidth(double seconds);
    void setLane(bool shown);
    void setCursorsShown(bool shown);
    void moveCursor(int cursor, double seconds);
    void chooseSignals();
    void addLaneBits(QMenu& menu);
    void change(const ScopeSetup& setup);
    void applyModules();
    void showTime();
    void showTrigger();
    void restartTrigger();
    /// The next frame is drawn whether it rolls or not.
    void touch();
    void drawLive(const History& history, TimePoint now);
    void draw(const History& history, double now);
    void moveUnder(double share);

    QVBoxLayout* m_layout;
    ScopeBar* m_bar;
    ScopeFiles* m_files;
    TriggerControl* m_trigger;
    QList<QAction*> m_menuActions;
    ScopeStrips* m_strips = nullptr;
    CursorPanel* m_readings = nullptr;  ///< there since the first cursors
    QBoxLayout* m_stripsAndReadings = nullptr;
    ScopeSetup m_setup = ScopeSetup::usual();
    std::vector<ScopeModule> m_modules;
    std::optional<ModuleIndex> m_selected;
    std::shared_ptr<const ScopeRecord> m_record;
    std::unique_ptr<Underlay> m_under;
    ScopeOrigin m_origin;                            ///< of what is live
    std::optional<TimePoint> m_zero;                 ///< of the live history
    bool m_another = false;                          ///< history than the strips have shown
    std::optional<ScopeTrigger::Picture> m_picture;  ///< of the trigger, that was shown last
    bool m_touched = true;
    bool m_everythingWanted = false;
};

}  // namespace nmc
