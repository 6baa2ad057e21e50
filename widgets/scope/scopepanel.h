// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "model/scope/scopetrigger.h"
#include "widgets/scope/scoperecord.h"
#include "widgets/scope/scopesetup.h"

class QBoxLayout;
class QMenu;
class QVBoxLayout;

namespace nmc {

class CursorPanel;
class Requests;
class ScopeBar;
class ScopeFiles;
class ScopePresets;
class ScopeStrips;
class TriggerControl;
class TriggerRecords;
class Underlay;

/// The scope: its tool bar, the strips, and the cursor readings. It rolls with the live samples, stands still
/// while paused, or shows a record. The charts are built when the panel or a record is first shown, and
/// painted only while the panel is visible.
class ScopePanel : public QWidget {
    Q_OBJECT

public:
    explicit ScopePanel(Requests& requests, QWidget* parent = nullptr);
    ~ScopePanel() override;

    /// How to read the live samples, and which module is selected.
    void showModules(std::vector<ScopeModule> modules, std::optional<ModuleIndex> selected);
    [[nodiscard]] const std::vector<ScopeModule>& modules() const { return m_modules; }
    /// Call at most 60 times a second. Nothing of `history` is kept except what this frame shows.
    void showHistory(const History& history, TimePoint now);
    /// True while strips of the last frame are still to be painted.
    [[nodiscard]] bool isPainting() const;
    /// Shows a record instead of the live samples, until backToLive().
    void showRecord(std::shared_ptr<const ScopeRecord> record);
    void backToLive();
    /// Shows a record under the live traces, until removeUnder() or the next call.
    void showUnder(std::shared_ptr<const ScopeRecord> record);
    void removeUnder();
    [[nodiscard]] bool showsRecord() const { return m_record != nullptr; }
    /// The user's arrangement.
    void setSetup(const ScopeSetup& setup);
    [[nodiscard]] const ScopeSetup& setup() const { return m_setup; }
    /// The modules that it needs whichever is selected: those of its strips, and of the trigger.
    [[nodiscard]] std::set<ModuleIndex> watchedModules() const;
    /// Where the live samples come from.
    void showSession(const QString& port, bool simulated);
    [[nodiscard]] ScopeFiles& files() { return *m_files; }
    [[nodiscard]] ScopePresets& presets() { return *m_presets; }

signals:
    void setupChanged(const nmc::ScopeSetup& setup);
    /// The display must change: showHistory() must be called soon, even if no samples have arrived.
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
    void setCursorsShown(bool shown);
    void moveCursor(int cursor, double seconds);
    [[nodiscard]] ScopeSetup visibleSetup() const;
    void chooseSignals();
    void addLaneBits(QMenu& menu);
    void change(const ScopeSetup& setup);
    /// Changes one part of the setup.
    template <typename T>
    void set(T ScopeSetup::*part, const T& value);
    void applyModules();
    void showWidth();
    void showTime();
    void showTrigger();
    void restartTrigger();
    /// Makes sure that the next frame is drawn, whether the scope rolls or not.
    void touch();
    void drawLive(const History& history, TimePoint now);
    void draw(const History& history, double now);
    void moveUnder(double share);

    QVBoxLayout* m_layout;
    ScopeBar* m_bar;
    ScopeFiles* m_files;
    TriggerControl* m_trigger;
    TriggerRecords* m_records;
    ScopePresets* m_presets;
    QList<QAction*> m_menuActions;
    ScopeStrips* m_strips = nullptr;
    CursorPanel* m_readings = nullptr;  ///< null until cursors are first shown
    QBoxLayout* m_stripsAndReadings = nullptr;
    ScopeSetup m_setup = ScopeSetup::usual();
    std::vector<ScopeModule> m_modules;
    std::optional<ModuleIndex> m_selected;
    std::shared_ptr<const ScopeRecord> m_record;
    std::unique_ptr<Underlay> m_under;
    ScopeOrigin m_origin;             ///< of the live samples
    std::optional<TimePoint> m_zero;  ///< of the live history
    /// Its date in ms of Unix time: asking for the time zone would be a large part of a frame.
    qint64 m_zeroMs = 0;
    bool m_another = false;  ///< the live history is not the one that the strips have shown
    std::optional<ScopeTrigger::Picture> m_picture;  ///< the trigger's picture that was shown last
    bool m_touched = true;
    bool m_everythingWanted = false;
};

}  // namespace nmc
