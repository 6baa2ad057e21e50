<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en">
<context>
    <name>CommandLine</name>
    <message>
        <source>Control panel for Networked Modular Control motor modules.</source>
        <translation>Networked Modular Control（NMC）モーターモジュール用の操作パネル。</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Baud rate of the chain: 9600, 19200 (default), 57600 or 115200.</source>
        <translation>チェーンのボーレート：9600、19200（既定）、57600、115200。</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Connect to the built-in simulator at startup. CHAIN lists its modules, the one farthest from the host first; the default is %1.</source>
        <translation>起動時に内蔵シミュレーターへ接続します。チェーンには、ホストから最も遠いものから順にモジュールを並べます。既定は%1です。</translation>
    </message>
    <message>
        <source>CHAIN</source>
        <translation>チェーン</translation>
    </message>
    <message>
        <source>List the serial ports of this computer.</source>
        <translation>このコンピューターのシリアルポートを一覧表示します。</translation>
    </message>
    <message>
        <source>Show this help.</source>
        <translation>このヘルプを表示します。</translation>
    </message>
    <message>
        <source>Show the version.</source>
        <translation>バージョンを表示します。</translation>
    </message>
    <message>
        <source>Allow control lines to inject faults into the built-in simulator.</source>
        <translation>制御行による内蔵シミュレーターへの故障注入を許可します。</translation>
    </message>
    <message>
        <source>With --port or --simulator: connect read-only. Only status requests are sent, and closing does not stop motors. STOP ALL still works.</source>
        <translation>--portまたは--simulatorとの併用：読み取り専用で接続します。ステータス要求だけを送信し、終了してもモーターを停止しません。全停止は使用できます。</translation>
    </message>
    <message>
        <source>Machine file to open at startup.</source>
        <translation>起動時に開くマシンファイル。</translation>
    </message>
    <message>
        <source>Let other programs in from the start. With =control, one of them may move motors without the user being asked.</source>
        <translation>起動時から他のプログラムの接続を許可します。=controlを付けると、そのうち1つは確認なしでモーターを動かせます。</translation>
    </message>
    <message>
        <source>Connect to a serial port at startup, or to one at a device server: tcp://HOST:PORT or rfc2217://HOST:PORT.</source>
        <translation>起動時にシリアルポート、またはデバイスサーバーのポート(tcp://HOST:PORT または rfc2217://HOST:PORT)に接続します。</translation>
    </message>
</context>
<context>
    <name>Common</name>
    <message>
        <source>%1 of %2 modules answered.</source>
        <translation>%2台中%1台のモジュールが応答しました。</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>グループ%1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>ボーレート</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>Points and sequences</source>
        <translation>ポイントとシーケンス</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Travel and speed limits</source>
        <translation>移動範囲と速度の制限</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>バックラッシ</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>原点復帰</translation>
    </message>
    <message>
        <source>Limit stop</source>
        <translation>リミット停止</translation>
    </message>
    <message>
        <source>Acceleration time</source>
        <translation>加速時間</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメーター</translation>
    </message>
    <message>
        <source>How</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Home all</source>
        <translation>全軸原点復帰</translation>
    </message>
    <message>
        <source>limit 1</source>
        <translation>リミット1</translation>
    </message>
    <message>
        <source>limit 2</source>
        <translation>リミット2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>STOP ALL</source>
        <translation>全停止</translation>
    </message>
    <message>
        <source>Motor off</source>
        <translation>モーターオフ</translation>
    </message>
    <message>
        <source>Connect fully</source>
        <translation>通常接続に切替</translation>
    </message>
    <message>
        <source>steps/s</source>
        <translation>ステップ/s</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>%1/s²</source>
        <translation>%1/s²</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>位置偏差</translation>
    </message>
    <message>
        <source>E-stop input</source>
        <translation>E-stop入力</translation>
    </message>
    <message>
        <source>The motor holds its position.</source>
        <translation>モーターは位置を保持しています。</translation>
    </message>
    <message>
        <source>The motor follows the points of a path.</source>
        <translation>モーターはパスの点に追従しています。</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>シミュレーター</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>No module</source>
        <translation>モジュールなし</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>◂ Hold</source>
        <translation>◂ ジョグ</translation>
    </message>
    <message>
        <source>Hold ▸</source>
        <translation>ジョグ ▸</translation>
    </message>
    <message>
        <source>◂| Step</source>
        <translation>◂| ステップ</translation>
    </message>
    <message>
        <source>Step |▸</source>
        <translation>ステップ |▸</translation>
    </message>
    <message>
        <source>Moves forward while held, then stops.</source>
        <translation>押している間、正方向に動き、離すと停止します。</translation>
    </message>
    <message>
        <source>Moves in reverse while held, then stops.</source>
        <translation>押している間、逆方向に動き、離すと停止します。</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>チェーン</translation>
    </message>
    <message>
        <source>&amp;Scan again</source>
        <translation>再スキャン(&amp;S)</translation>
    </message>
    <message>
        <source>Resets every module and assigns new addresses. Asks first.</source>
        <translation>全モジュールをリセットし、新しいアドレスを割り当てます。実行前に確認します。</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>テキスト (*.txt)</translation>
    </message>
    <message>
        <source>Open machine</source>
        <translation>マシンを開く</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>ended at %1</source>
        <translation>%1に終了</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>すべての種類</translation>
    </message>
    <message>
        <source>All modules</source>
        <translation>全モジュール</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Max jog speed</source>
        <translation>最高ジョグ速度</translation>
    </message>
    <message>
        <source>The value at an A/D reading of 0.</source>
        <translation>A/D読み取り値が0のときの値です。</translation>
    </message>
    <message>
        <source>The module received a garbled command and did not carry it out.</source>
        <translation>モジュールが化けたコマンドを受信し、実行しませんでした。</translation>
    </message>
    <message>
        <source>Limit switch 1.</source>
        <translation>リミットスイッチ1です。</translation>
    </message>
    <message>
        <source>Limit switch 2.</source>
        <translation>リミットスイッチ2です。</translation>
    </message>
    <message>
        <source>Waiting for the home position.</source>
        <translation>原点位置を待っています。</translation>
    </message>
    <message>
        <source>Save as home</source>
        <translation>原点として保存</translation>
    </message>
    <message>
        <source>Save as home: the present position</source>
        <translation>原点として保存：現在位置</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Status byte</source>
        <translation>ステータスバイト</translation>
    </message>
    <message>
        <source>Home register</source>
        <translation>原点レジスター</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>生データ</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>ステータス%1</translation>
    </message>
    <message>
        <source>Saves the present position as home. The motor does not move.</source>
        <translation>現在位置を原点として保存します。モーターは動きません。</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Fast path</source>
        <translation>高速パス</translation>
    </message>
    <message>
        <source>Amplifier</source>
        <translation>アンプ</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>PWM value</source>
        <translation>PWM値</translation>
    </message>
    <message>
        <source>Abruptly</source>
        <translation>即停止</translation>
    </message>
    <message>
        <source>Smoothly</source>
        <translation>減速停止</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>インデックス</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>電流制限</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Start&amp;ing values</source>
        <translation>初期値(&amp;I)</translation>
    </message>
    <message>
        <source>Starting values: fill in</source>
        <translation>初期値：入力</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>State of the selected module</source>
        <translation>選択したモジュールの状態</translation>
    </message>
    <message>
        <source>%1, address %2</source>
        <translation>%1、アドレス%2</translation>
    </message>
    <message>
        <source>Pages of the module</source>
        <translation>モジュールのページ</translation>
    </message>
    <message>
        <source>A/D and PWM</source>
        <translation>A/DとPWM</translation>
    </message>
    <message>
        <source>A/D input</source>
        <translation>A/D入力</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>%1の名前</translation>
    </message>
    <message>
        <source>Off at stop</source>
        <translation>停止でオフ</translation>
    </message>
    <message>
        <source>%1 of 255</source>
        <translation>%1 / 255</translation>
    </message>
    <message>
        <source>? unknown</source>
        <translation>? 不明</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>ピン一覧</translation>
    </message>
    <message>
        <source>input</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>high</source>
        <translation>High</translation>
    </message>
    <message>
        <source>low</source>
        <translation>Low</translation>
    </message>
    <message>
        <source>Switches this output at once.</source>
        <translation>この出力を直ちに切り替えます。</translation>
    </message>
    <message>
        <source>A search for home is running.</source>
        <translation>原点サーチの実行中です。</translation>
    </message>
    <message>
        <source>Home switch</source>
        <translation>原点スイッチ</translation>
    </message>
    <message>
        <source>Limit 1</source>
        <translation>リミット1</translation>
    </message>
    <message>
        <source>Limit 2</source>
        <translation>リミット2</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>制限時間</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>モーター電源</translation>
    </message>
    <message>
        <source>A/D</source>
        <translation>A/D</translation>
    </message>
    <message>
        <source>Goal position</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>The goal position</source>
        <translation>目標位置の値</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Use nearest</source>
        <translation>最も近い値を使用</translation>
    </message>
    <message>
        <source>Use nearest allowed position</source>
        <translation>最も近い値を使用：許可された位置</translation>
    </message>
    <message>
        <source>Zero here: set the present position to 0</source>
        <translation>現在位置を0に：位置の値を0に設定</translation>
    </message>
    <message>
        <source>Go home</source>
        <translation>原点へ移動</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>ロード</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>移動(&amp;G)</translation>
    </message>
    <message>
        <source>Go to the position</source>
        <translation>移動：この位置へ</translation>
    </message>
    <message>
        <source>Run &amp;reverse</source>
        <translation>逆方向運転(&amp;R)</translation>
    </message>
    <message>
        <source>Run reverse until stopped</source>
        <translation>逆方向運転：停止操作をするまで</translation>
    </message>
    <message>
        <source>R&amp;un forward</source>
        <translation>正方向運転(&amp;U)</translation>
    </message>
    <message>
        <source>Run forward until stopped</source>
        <translation>正方向運転：停止操作をするまで</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1を使用</translation>
    </message>
    <message>
        <source>Sets the goal to the nearest allowed position. Nothing moves.</source>
        <translation>目標位置を、許可された最も近い位置に設定します。何も動きません。</translation>
    </message>
    <message>
        <source>Moves to the position, then holds.</source>
        <translation>その位置へ移動し、保持します。</translation>
    </message>
    <message>
        <source>Runs forward until stopped.</source>
        <translation>停止操作をするまで正方向に運転します。</translation>
    </message>
    <message>
        <source>Runs in reverse until stopped.</source>
        <translation>停止操作をするまで逆方向に運転します。</translation>
    </message>
    <message>
        <source>Motor current</source>
        <translation>モーター電流</translation>
    </message>
    <message>
        <source>Motor off: this module</source>
        <translation>モーターオフ：このモジュール</translation>
    </message>
    <message>
        <source>A/D %1</source>
        <translation>A/D %1</translation>
    </message>
    <message>
        <source>Switches servo and amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>サーボとアンプをオフにします。モーターは自由に回り、負荷が落下することがあります。</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>エキスパート</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>A/D (temperature)</source>
        <translation>A/D（温度）</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>Nothing to undo.</source>
        <translation>元に戻すものがありません。</translation>
    </message>
    <message>
        <source>Nothing to redo.</source>
        <translation>やり直すものがありません。</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>最高速度</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>周波数応答</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSVエクスポート…</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Square wave</source>
        <translation>矩形波</translation>
    </message>
    <message>
        <source>Method: how the command jumps</source>
        <translation>方式：指令の変化のしかた</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>Rise %1</source>
        <translation>立ち上がり %1</translation>
    </message>
    <message>
        <source>Overshoot %1</source>
        <translation>オーバーシュート %1</translation>
    </message>
    <message>
        <source>Steady-state error %1</source>
        <translation>定常偏差 %1</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>ステップ応答</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>オーバーシュート</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Cursor readings</source>
        <translation>カーソル値</translation>
    </message>
    <message>
        <source>Cursor 1</source>
        <translation>カーソル1</translation>
    </message>
    <message>
        <source>Cursor 2</source>
        <translation>カーソル2</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>カーソル</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>画像 (PNG)(&amp;P)…</translation>
    </message>
    <message>
        <source>The visible plot as an image.</source>
        <translation>表示中のグラフの画像です。</translation>
    </message>
    <message>
        <source>&amp;Vector picture (SVG)…</source>
        <translation>ベクター画像 (SVG)(&amp;V)…</translation>
    </message>
    <message>
        <source>The visible plot as lines that stay sharp at any size.</source>
        <translation>表示中のグラフを、どの大きさでも鮮明な線で保存します。</translation>
    </message>
    <message>
        <source>P&amp;age (PDF)…</source>
        <translation>ページ (PDF)(&amp;A)…</translation>
    </message>
    <message>
        <source>The visible plot on a page for printing or a report.</source>
        <translation>表示中のグラフを、印刷やレポート用の1ページにします。</translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation>印刷(&amp;R)…</translation>
    </message>
    <message>
        <source>Prints the visible plot on one of this computer&apos;s printers.</source>
        <translation>表示中のグラフを、このコンピューターのプリンターで印刷します。</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>画像をコピー(&amp;C)</translation>
    </message>
    <message>
        <source>SIMULATOR, no real motor moved</source>
        <translation>シミュレーター：実際のモーターは動いていません</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1ファイル (*.%2)</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>トリガー</translation>
    </message>
    <message>
        <source>NMC Panel %1</source>
        <translation>NMC Panel %1</translation>
    </message>
    <message>
        <source>Overlay: %1</source>
        <translation>重ね表示：%1</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>スコープ</translation>
    </message>
    <message>
        <source>of 255</source>
        <translation>/ 255</translation>
    </message>
    <message>
        <source>Opens the port and looks for modules. Nothing moves.</source>
        <translation>ポートを開いてモジュールを検索します。何も動きません。</translation>
    </message>
    <message>
        <source>goes to all modules</source>
        <translation>全モジュールに送信</translation>
    </message>
    <message>
        <source>Operator mode</source>
        <translation>オペレーターモード</translation>
    </message>
    <message>
        <source>Asks for the PIN.</source>
        <translation>PINの入力が必要です。</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>到着</translation>
    </message>
    <message>
        <source>Work offsets</source>
        <translation>ワークオフセット</translation>
    </message>
    <message>
        <source>waits for the port</source>
        <translation>ポート待ち</translation>
    </message>
    <message>
        <source>A sequence is already running.</source>
        <translation>シーケンスはすでに運転中です。</translation>
    </message>
    <message>
        <source>Its name on this machine. Sends nothing.</source>
        <translation>このマシンでの名前です。何も送信しません。</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Other programs</source>
        <translation>他のプログラム</translation>
    </message>
</context>
<context>
    <name>Gains</name>
    <message>
        <source>Position gain</source>
        <translation>位置ゲイン</translation>
    </message>
    <message>
        <source>Derivative gain</source>
        <translation>微分ゲイン</translation>
    </message>
    <message>
        <source>Integral gain</source>
        <translation>積分ゲイン</translation>
    </message>
    <message>
        <source>Integration limit</source>
        <translation>積分制限</translation>
    </message>
    <message>
        <source>Output limit</source>
        <translation>出力制限</translation>
    </message>
    <message>
        <source>Position error limit</source>
        <translation>位置偏差上限</translation>
    </message>
    <message>
        <source>Servo rate divisor</source>
        <translation>分周比</translation>
    </message>
    <message>
        <source>Deadband compensation</source>
        <translation>不感帯補償</translation>
    </message>
    <message>
        <source>Kp, position gain: output per count of position error. Set Kd first; then raise Kp with small, fast test moves until the motor starts to overshoot, and back off a little.</source>
        <translation>Kp、位置ゲイン：位置偏差1カウントあたりの出力。先にKdを設定します。次に、短く速いテスト移動をしながらオーバーシュートし始めるまでKpを上げ、少し戻します。</translation>
    </message>
    <message>
        <source>Kd, derivative gain: damping. Start here, with Kp and Ki at 0: raise Kd until the motor starts to hum, then back off a little.</source>
        <translation>Kd、微分ゲイン：減衰（ダンピング）。KpとKiを0にして、ここから始めます。モーターがうなり始めるまでKdを上げ、少し戻します。</translation>
    </message>
    <message>
        <source>Ki, integral gain: removes the steady-state error that Kp and Kd leave. Set IL to 16000 first, then raise Ki until the error settles fast enough. Adds some overshoot.</source>
        <translation>Ki、積分ゲイン：KpとKdで残る定常偏差を取り除きます。先にILを16000にし、偏差が十分速く整定するまでKiを上げます。オーバーシュートが少し増えます。</translation>
    </message>
    <message>
        <source>IL, integration limit: limits the integral of the error. Last, lower it to the smallest value that still removes the steady-state error. 0 clears the integral.</source>
        <translation>IL、積分制限：偏差の積分を制限します。最後に、定常偏差を取り除ける最小の値まで下げます。0にすると積分をクリアします。</translation>
    </message>
    <message>
        <source>OL, output limit: the largest PWM value; 255 is 100 %. Use 127 for a 12 V motor on a 24 V supply.</source>
        <translation>OL、出力制限：PWM値の最大値。255が100%です。12 Vモーターを24 V電源で使う場合は127にします。</translation>
    </message>
    <message>
        <source>CL, current limit, compared with the A/D value. 0: off. Odd: limits while the A/D value is above CL. Even: limits while it is below CL.</source>
        <translation>CL、電流制限：A/D値と比較されます。0：オフ。奇数：A/D値がCLより大きい間、制限します。偶数：A/D値がCLより小さい間、制限します。</translation>
    </message>
    <message>
        <source>EL, position error limit in counts: the servo switches off when the error exceeds it, for example after a collision or a stall.</source>
        <translation>EL、位置偏差上限（カウント）：衝突や拘束などで偏差がこれを超えると、サーボがオフになります。</translation>
    </message>
    <message>
        <source>SR, servo rate divisor: one servo tick is SR × 0.512 ms. A slower rate damps heavy loads with less Kd. Changing SR changes the meaning of every velocity and acceleration.</source>
        <translation>SR、サーボレート分周比：サーボ1周期はSR x 0.512 msです。周期を長くすると、重い負荷の振動を小さなKdで抑えられます。SRを変えると、すべての速度と加速度の意味が変わります。</translation>
    </message>
    <message>
        <source>DB, deadband compensation: added to every PWM value except 0, for amplifiers with a deadband near zero. Version 4 and later.</source>
        <translation>DB、不感帯補償：0以外のPWM値に加算されます。0付近に不感帯があるアンプ用です。バージョン4以降。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>A/D above</source>
        <translation>A/D超過</translation>
    </message>
    <message>
        <source>A/D below</source>
        <translation>A/D未満</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 %2→%3</translation>
    </message>
</context>
<context>
    <name>LoopTestTexts</name>
    <message numerus="yes">
        <source>%n frequencies up to %1 Hz</source>
        <translation>
            <numerusform>%n点の周波数、%1 Hzまで</numerusform>
        </translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) %1 Hz</source>
        <translation>帯域幅 (-3 dB) %1 Hz</translation>
    </message>
    <message>
        <source>Bandwidth (-3 dB) not reached</source>
        <translation>帯域幅 (-3 dB)：測定範囲外</translation>
    </message>
    <message>
        <source>Resonance %1 dB</source>
        <translation>共振 %1 dB</translation>
    </message>
    <message>
        <source>Phase margin %1° at %2 Hz</source>
        <translation>位相余裕 %1°（%2 Hz）</translation>
    </message>
    <message>
        <source>Phase margin not reached</source>
        <translation>位相余裕：測定範囲外</translation>
    </message>
    <message>
        <source>Gain margin %1</source>
        <translation>ゲイン余裕 %1</translation>
    </message>
    <message>
        <source>Gain margin not reached</source>
        <translation>ゲイン余裕：測定範囲外</translation>
    </message>
    <message>
        <source>Edit the gains to see what this loop would do with them.</source>
        <translation>ゲインを編集すると、そのゲインでのこのループの応答を確認できます。</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: OL or IL cut off the filter&apos;s output while measuring. Use a smaller amplitude.</source>
        <translation>入力欄のゲインでは不明です：測定中にOLまたはILがフィルター出力を制限しました。振幅を小さくしてください。</translation>
    </message>
    <message>
        <source>OL or IL cut off the filter&apos;s output while measuring: for small motions, the loop responds differently. Use a smaller amplitude or a lower speed.</source>
        <translation>測定中にOLまたはILがフィルター出力を制限しました。小さな動作ではループの応答が異なります。振幅または速度を小さくしてください。</translation>
    </message>
    <message>
        <source>unstable, the motor would oscillate</source>
        <translation>不安定、モーターが発振します</translation>
    </message>
    <message>
        <source>known only from %1 to %2 Hz</source>
        <translation>%1～%2 Hzでのみ既知</translation>
    </message>
    <message>
        <source>With the gains in the fields: %1</source>
        <translation>入力欄のゲインでは：%1</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: SR differs from that of the measurement.</source>
        <translation>入力欄のゲインでは不明です：SRが測定時と異なります。</translation>
    </message>
    <message>
        <source>Not known for the gains in the fields: DB differs from that of the measurement.</source>
        <translation>入力欄のゲインでは不明です：DBが測定時と異なります。</translation>
    </message>
    <message>
        <source>known only at %1 Hz</source>
        <translation>%1 Hzでのみ既知</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>About NMC Panel</source>
        <translation>NMC Panelについて</translation>
    </message>
    <message>
        <source>A control panel for PIC-SERVO, PIC-STEP and PIC-I/O modules on one serial line.

Free software under the GNU General Public License, version 3 or later. Icons: Tabler, MIT licence. Built with Qt %1.</source>
        <translation>1本のシリアル回線につながったPIC-SERVO、PIC-STEPおよびPIC-I/Oモジュール用の操作パネルです。

GNU General Public Licenseバージョン3以降に基づくフリーソフトウェアです。アイコン：Tabler、MITライセンス。Qt %1でビルド。</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>レイアウトを初期化(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>&amp;Safety</source>
        <translation>安全(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;About NMC Panel</source>
        <translation>NMC Panelについて(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>コマンドを検索(&amp;F)…</translation>
    </message>
    <message>
        <source>Colour&amp;s</source>
        <translation>配色(&amp;S)</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>The new language takes effect the next time you start NMC Panel.</source>
        <translation>新しい言語は、次回のNMC Panelの起動から有効になります。</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>システム(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>マニュアル(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>キーボードショートカット(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>問題を報告(&amp;R)…</translation>
    </message>
</context>
<context>
    <name>MessageLines</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n回</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>終了：%1</translation>
    </message>
</context>
<context>
    <name>ModelTexts</name>
    <message>
        <source>Gain %1</source>
        <translation>ゲイン %1</translation>
    </message>
    <message>
        <source>counts/s per PWM count</source>
        <translation>カウント/s（PWM 1あたり）</translation>
    </message>
    <message>
        <source>Time constant %1</source>
        <translation>時定数 %1</translation>
    </message>
    <message>
        <source>Friction %1</source>
        <translation>摩擦 %1</translation>
    </message>
    <message>
        <source>of 255 PWM</source>
        <translation>/ 255 PWM</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>負荷 %1</translation>
    </message>
    <message>
        <source>Model error %1 counts RMS; encoder and timing account for %2.</source>
        <translation>モデル誤差 %1カウントRMS。エンコーダーとタイミングで説明できるのは%2です。</translation>
    </message>
    <message>
        <source>Too few samples. Record for longer, or raise the baud rate.</source>
        <translation>サンプルが不足しています。記録時間を延ばすか、ボーレートを上げてください。</translation>
    </message>
    <message>
        <source>The shaft did not move. Check motor power and brake, or use a larger step.</source>
        <translation>シャフトが動きませんでした。モーター電源とブレーキを確認するか、ステップを大きくしてください。</translation>
    </message>
    <message>
        <source>The shaft moved away from its goal. Check the direction on the Axis page.</source>
        <translation>シャフトが目標位置から離れる方向に動きました。「軸」ページで方向を確認してください。</translation>
    </message>
    <message>
        <source>The motor keeps oscillating. Lower Kp or raise Kd, then step again.</source>
        <translation>モーターの発振が続いています。Kpを下げるかKdを上げて、もう一度ステップを実行してください。</translation>
    </message>
    <message>
        <source>The model does not fit the step. Check for backlash, an elastic belt, a hard stop or a current limit.</source>
        <translation>モデルがステップに合いません。バックラッシ、ベルトの伸び、メカストッパー、電流制限を確認してください。</translation>
    </message>
    <message>
        <source>These steps do not determine the motor gain. Add a larger step, so that the motor gets close to a steady speed.</source>
        <translation>これらのステップではモーターのゲインが定まりません。モーターが一定速度に近づくように、より大きいステップを追加してください。</translation>
    </message>
    <message>
        <source>These steps do not determine the time constant. Repeat the step, or raise the baud rate.</source>
        <translation>これらのステップでは時定数が定まりません。ステップを繰り返すか、ボーレートを上げてください。</translation>
    </message>
    <message>
        <source>Overshoot %1, settling %2</source>
        <translation>オーバーシュート %1、整定 %2</translation>
    </message>
    <message>
        <source>Steady-state error %1 counts</source>
        <translation>定常偏差 %1カウント</translation>
    </message>
    <message>
        <source>Phase margin %1°, gain margin %2</source>
        <translation>位相余裕 %1°、ゲイン余裕 %2</translation>
    </message>
    <message>
        <source>Phase margin %1°</source>
        <translation>位相余裕 %1°</translation>
    </message>
    <message>
        <source>Uncertain: step once more. Until then the suggested gains are conservative.</source>
        <translation>不確かです。もう一度ステップを実行してください。それまで提案ゲインは控えめになります。</translation>
    </message>
    <message>
        <source>The motor stopped abruptly short of its goal. Something is in its way: a hard stop, or its load. Clear the way, or step in the other direction.</source>
        <translation>モーターが目標の手前で急に止まりました。メカストッパーや駆動対象など、何かが妨げています。空間を空けるか、逆方向にステップしてください。</translation>
    </message>
    <message>
        <source>In %1 of 100 cases the motor stops too far from its goal.</source>
        <translation>100回中%1回は、モーターが目標から離れすぎて止まります。</translation>
    </message>
    <message>
        <source>Amplifier deadband %1</source>
        <translation>アンプの不感帯 %1</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>バックラッシ %1</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>カウント</translation>
    </message>
    <message>
        <source>A resonance above %1 Hz would not show; the margins allow for one.</source>
        <translation>%1 Hzを超える共振はこのステップでは見えません。余裕はそれを見込んでいます。</translation>
    </message>
    <message>
        <source>The motor probably has more than %1 counts of play: that much motion is lost at each reversal. Take up the play between motor and encoder.</source>
        <translation>モーターにおそらく%1カウントを超えるバックラッシがあります。反転時にその分が失われています。モーターとエンコーダーの間のバックラッシを取り除いてください。</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>%1 counts, %2</source>
        <translation>%1カウント、%2</translation>
    </message>
    <message>
        <source>Settling to ±%1 %: %2</source>
        <translation>±%1%への整定：%2</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>%1の調整</translation>
    </message>
    <message>
        <source>simulated; no real motor moved</source>
        <translation>シミュレーション：実際のモーターは動いていません</translation>
    </message>
    <message>
        <source>Speed while measuring %1 counts/s</source>
        <translation>測定中の速度 %1 カウント/s</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>モーター</translation>
    </message>
    <message>
        <source>%1 counts in %2 s</source>
        <translation>%1 カウント、%2 s</translation>
    </message>
    <message>
        <source>Settling to ±%1 counts for %2 s: %3</source>
        <translation>±%1 カウントに %2 s 間整定: %3</translation>
    </message>
    <message>
        <source>Peak error %1</source>
        <translation>最大偏差 %1</translation>
    </message>
    <message>
        <source>RMS error %1</source>
        <translation>偏差の実効値 %1</translation>
    </message>
</context>
<context>
    <name>ResponseTexts</name>
    <message>
        <source>too few samples</source>
        <translation>サンプル不足</translation>
    </message>
    <message>
        <source>did not reach 90 %</source>
        <translation>90%に未到達</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>記録なし</translation>
    </message>
    <message>
        <source>Very fast profile</source>
        <translation>超高速プロファイル</translation>
    </message>
    <message>
        <source>Stop here, at the goal</source>
        <translation>目標位置で「ここで停止」</translation>
    </message>
    <message>
        <source>A move with velocity and acceleration so high that its profile reaches the goal in one servo tick. CMC and SC stop here, at the goal, instead.</source>
        <translation>速度と加速度が非常に大きく、プロファイルが1周期で目標位置に達する移動です。CMCとSCでは、代わりに目標位置で「ここで停止」します。</translation>
    </message>
    <message>
        <source>The servo holds the goal at once, without a profile. Not available with version 1.</source>
        <translation>サーボがプロファイルなしで直ちに目標位置を保持します。バージョン1では使用できません。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>limited to %1</source>
        <translation>%1に制限</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1以上</translation>
    </message>
    <message>
        <source>samples missing, repeat</source>
        <translation>サンプル欠落、再実行</translation>
    </message>
    <message>
        <source>%1, off its goal</source>
        <translation>%1、目標位置からずれ</translation>
    </message>
    <message>
        <source>never constant</source>
        <translation>一定になりません</translation>
    </message>
    <message>
        <source>Profiled move</source>
        <translation>プロファイル移動</translation>
    </message>
    <message>
        <source>No step: moves there and back with the velocity and acceleration below, judged by a window and a dwell. Not available with version 1.</source>
        <translation>ステップではなく、下の速度と加速度で往復移動し、整定幅と保持時間で評価します。バージョン 1 では使用できません。</translation>
    </message>
    <message>
        <source>%1 of %2 settled</source>
        <translation>%2 回中 %1 回整定</translation>
    </message>
    <message>
        <source>%1 to %2 ms (%3)</source>
        <translation>%1～%2 ms (%3)</translation>
    </message>
</context>
<context>
    <name>Scope</name>
    <message>
        <source>%1, by %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>From %1; 0 s is %2</source>
        <translation>%1から（0 s = %2）</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>拡大</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>前へ</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>後へ</translation>
    </message>
    <message>
        <source>Go to live</source>
        <translation>ライブへ</translation>
    </message>
    <message>
        <source>Values up</source>
        <translation>値を上へ</translation>
    </message>
    <message>
        <source>Values down</source>
        <translation>値を下へ</translation>
    </message>
    <message>
        <source>Zoom values in</source>
        <translation>値を拡大</translation>
    </message>
    <message>
        <source>Zoom values out</source>
        <translation>値を縮小</translation>
    </message>
    <message>
        <source>Fit the values</source>
        <translation>値に合わせる</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>command, calculated</source>
        <translation>指令位置（計算値）</translation>
    </message>
    <message>
        <source>error, calculated</source>
        <translation>偏差（計算値）</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>PWM, calculated</source>
        <translation>PWM（計算値）</translation>
    </message>
    <message>
        <source>A/D 2</source>
        <translation>A/D 2</translation>
    </message>
    <message>
        <source>A/D 3</source>
        <translation>A/D 3</translation>
    </message>
    <message>
        <source>count</source>
        <translation>カウント</translation>
    </message>
    <message>
        <source>count rate</source>
        <translation>カウントレート</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>カウント</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>カウント/s</translation>
    </message>
    <message>
        <source>One row per reply, can be reopened here (*.csv)</source>
        <translation>応答ごとに1行、ここで開き直せます (*.csv)</translation>
    </message>
    <message>
        <source>One column per signal, for other programs only (*.csv)</source>
        <translation>信号ごとに1列、ほかのプログラム専用 (*.csv)</translation>
    </message>
    <message>
        <source>One column per signal, every millisecond, for other programs only (*.csv)</source>
        <translation>信号ごとに1列、1 msごと、ほかのプログラム専用 (*.csv)</translation>
    </message>
    <message>
        <source>custom trace %1</source>
        <translation>カスタム波形 %1</translation>
    </message>
    <message>
        <source>error, reported</source>
        <translation>偏差（報告値）</translation>
    </message>
</context>
<context>
    <name>StepperWords</name>
    <message>
        <source>%1 steps/s</source>
        <translation>%1ステップ/s</translation>
    </message>
    <message>
        <source>%1x: %2 to %3 steps/s</source>
        <translation>%1x：%2～%3ステップ/s</translation>
    </message>
    <message>
        <source>Runs at %1: speed %2, the minimum profile speed.</source>
        <translation>%1で運転します：速度%2、最小プロファイル速度です。</translation>
    </message>
    <message>
        <source>Runs at %1: speed %2 of 250.</source>
        <translation>%1で運転します：速度%2 / 250。</translation>
    </message>
    <message>
        <source>Runs at %1: timer count %2.</source>
        <translation>%1で運転します：タイマー値%2。</translation>
    </message>
    <message>
        <source>%1 steps/s²</source>
        <translation>%1ステップ/s²</translation>
    </message>
    <message>
        <source>The motor is already there.</source>
        <translation>モーターはすでにその位置にあります。</translation>
    </message>
    <message>
        <source>Takes %1 s. Too short for that speed: peaks at %2.</source>
        <translation>所要時間%1 s。この速度に達するには短すぎます：最高%2。</translation>
    </message>
    <message>
        <source>Takes %1 s, peak speed %2.</source>
        <translation>所要時間%1 s、最高速度%2。</translation>
    </message>
    <message>
        <source>Ramp of %1.</source>
        <translation>加減速：%1。</translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>error, zoomed (%1)</source>
        <translation>偏差、拡大（%1）</translation>
    </message>
    <message>
        <source>PWM, calculated (of 255)</source>
        <translation>PWM、計算値（255中）</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Port &quot;%1&quot; not found. Only the simulator is available: --simulator.</source>
        <translation>ポート「%1」が見つかりません。使用できるのはシミュレーターだけです：--simulator。</translation>
    </message>
    <message>
        <source>Port &quot;%1&quot; not found. Available ports: %2.</source>
        <translation>ポート「%1」が見つかりません。使用できるポート：%2。</translation>
    </message>
    <message>
        <source>These modules do not support the baud rate &quot;%1&quot;. Use %2.</source>
        <translation>これらのモジュールはボーレート「%1」に対応していません。%2を使用してください。</translation>
    </message>
    <message>
        <source>The simulator does not understand the chain &quot;%1&quot;: %2 An example: --simulator=servo,servo@1</source>
        <translation>シミュレーターがチェーン「%1」を解釈できません：%2 例：--simulator=servo,servo@1</translation>
    </message>
    <message>
        <source>Unknown option &quot;%1&quot;. Use --help for a list.</source>
        <translation>不明なオプション「%1」です。--helpで一覧を表示します。</translation>
    </message>
    <message>
        <source>No display found: neither DISPLAY nor WAYLAND_DISPLAY is set.</source>
        <translation>ディスプレイが見つかりません。DISPLAYもWAYLAND_DISPLAYも設定されていません。</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>再スキャン</translation>
    </message>
    <message>
        <source>Use simulator</source>
        <translation>シミュレーターを使用</translation>
    </message>
    <message>
        <source>Choose another port</source>
        <translation>別のポートを選択</translation>
    </message>
    <message>
        <source>Motor state unknown; no motor was moving when last seen.</source>
        <translation>モーターの状態は不明です。最後の確認時に動いていたモーターはありません。</translation>
    </message>
    <message>
        <source>Your user account has no permission to use %1.</source>
        <translation>お使いのユーザーアカウントには%1の使用権限がありません。</translation>
    </message>
    <message>
        <source>Ask your system administrator for access.</source>
        <translation>システム管理者に権限を依頼してください。</translation>
    </message>
    <message>
        <source>It belongs to the group %1. Run %2, then log out and in again.</source>
        <translation>このポートはグループ%1に属しています。%2を実行し、ログアウトしてから再度ログインしてください。</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>コマンドをコピー</translation>
    </message>
    <message>
        <source>%1 is used by another program.</source>
        <translation>%1は別のプログラムが使用中です。</translation>
    </message>
    <message>
        <source>Close it and try again.</source>
        <translation>そのプログラムを終了して、もう一度試してください。</translation>
    </message>
    <message>
        <source>Close it and try again. Or use nmcctl through it: in its Chain menu, switch on &quot;Let programs in&quot;, and leave out --port.</source>
        <translation>そのプログラムを終了して、もう一度試してください。または、そのプログラムを通してnmcctlを使います：そこで「チェーン」の「プログラムの接続を許可」をオンにし、--portを付けずに実行してください。</translation>
    </message>
    <message>
        <source>%1 not found.</source>
        <translation>%1が見つかりません。</translation>
    </message>
    <message>
        <source>Check that the adapter is plugged in. Its name may have changed.</source>
        <translation>アダプターが差し込まれていることを確認してください。名前が変わった可能性もあります。</translation>
    </message>
    <message>
        <source>%1 is not a serial port.</source>
        <translation>%1はシリアルポートではありません。</translation>
    </message>
    <message>
        <source>Choose the adapter&apos;s port, for example /dev/ttyUSB0.</source>
        <translation>アダプターのポートを選択してください。例：/dev/ttyUSB0。</translation>
    </message>
    <message>
        <source>%1 does not support the selected baud rate.</source>
        <translation>%1は選択したボーレートに対応していません。</translation>
    </message>
    <message>
        <source>Choose another baud rate; every adapter supports 19 200 Bd.</source>
        <translation>別のボーレートを選択してください。19 200 Bdにはすべてのアダプターが対応しています。</translation>
    </message>
    <message>
        <source>The adapter at %1 was unplugged. %2</source>
        <translation>%1のアダプターが抜かれました。%2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then plug the adapter in again.</source>
        <translation>必要ならハードウェア停止装置を使用し、その後アダプターを差し直してください。</translation>
    </message>
    <message>
        <source>Could not open %1.</source>
        <translation>%1を開けませんでした。</translation>
    </message>
    <message>
        <source>System message: %1</source>
        <translation>システムのメッセージ：%1</translation>
    </message>
    <message>
        <source>Not every module answered at %1 Bd, so the modules cannot be used yet.</source>
        <translation>%1 Bdで応答しないモジュールがあるため、まだモジュールを使用できません。</translation>
    </message>
    <message>
        <source>Module %1 did not answer at %2 Bd, so the modules cannot be used yet.</source>
        <translation>モジュール%1が%2 Bdで応答しなかったため、まだモジュールを使用できません。</translation>
    </message>
    <message>
        <source>Usually the cable is too long for this baud rate, or termination is missing. Choose a lower baud rate for %1 and scan again.</source>
        <translation>多くの場合、このボーレートに対してケーブルが長すぎるか、終端がありません。%1のボーレートを下げて、再スキャンしてください。</translation>
    </message>
    <message>
        <source>Modules answered at %1, but their answers were garbled.</source>
        <translation>%1でモジュールが応答しましたが、応答が化けていました。</translation>
    </message>
    <message>
        <source>Usually noise on the cable, or two modules answering at once. Check the cable, its termination and the ADDR_IN jumpers.</source>
        <translation>多くの場合、ケーブルのノイズか、2台のモジュールの同時応答です。ケーブル、終端、ADDR_INジャンパーを確認してください。</translation>
    </message>
    <message>
        <source>Port %1, %2 Bd</source>
        <translation>ポート%1、%2 Bd</translation>
    </message>
    <message>
        <source>module %1</source>
        <translation>モジュール%1</translation>
    </message>
    <message>
        <source>module %1 &quot;%2&quot;</source>
        <translation>モジュール%1「%2」</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two.</source>
        <translation>番号は遠端から始まります。%1の次の、PC側のモジュールを調べてください。まずその電源、次に両者の間のプラグです。</translation>
    </message>
    <message>
        <source>Work with %1</source>
        <translation>%1で作業</translation>
    </message>
    <message>
        <source>Connected to %1: %2 at %3 Bd.</source>
        <translation>%1に接続しました：%2、%3 Bd。</translation>
    </message>
    <message>
        <source>Nothing moves until you command it. Gains are unknown until you apply them.</source>
        <translation>操作するまで何も動きません。ゲインは、適用するまで不明です。</translation>
    </message>
    <message>
        <source>Disconnected from %1.</source>
        <translation>%1から切断しました。</translation>
    </message>
    <message>
        <source>All modules on %1 stopped answering. %2</source>
        <translation>%1のすべてのモジュールが応答しなくなりました。%2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Then check the power of the modules and the cable at the PC.</source>
        <translation>必要ならハードウェア停止装置を使用してください。その後、モジュールの電源とPC側のケーブルを確認してください。</translation>
    </message>
    <message>
        <source>The link is unreliable: %1 of the last %2 exchanges failed.</source>
        <translation>通信が不安定です。直近%2回の通信のうち%1回が失敗しました。</translation>
    </message>
    <message>
        <source>Updates are slow (%1 per second) because the USB adapter waits %2 ms before passing data on.</source>
        <translation>USBアダプターがデータを渡すまで%2 ms待つため、更新が遅くなっています（毎秒%1回）。</translation>
    </message>
    <message>
        <source>Set its latency timer to 1 ms.</source>
        <translation>アダプターのレイテンシタイマーを1 msに設定してください。</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown: it was moving.</source>
        <translation>モジュール%1が%2秒間応答していません。モーターの状態は不明です。最後の確認時は動いていました。</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. Motor state unknown; it was stopped when last seen.</source>
        <translation>モジュール%1が%2秒間応答していません。モーターの状態は不明です。最後の確認時は停止していました。</translation>
    </message>
    <message>
        <source>Module %1 has not answered for %2 s. The state of its outputs is unknown.</source>
        <translation>モジュール%1が%2秒間応答していません。出力の状態は不明です。</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed. Check its power and the plug next to it; the panel keeps trying.</source>
        <translation>必要ならハードウェア停止装置を使用してください。モジュールの電源と隣のプラグを確認してください。パネルは試行を続けます。</translation>
    </message>
    <message>
        <source>Module %1 may not answer until module %2 has its address again.</source>
        <translation>モジュール%2のアドレスが戻るまで、モジュール%1は応答しないことがあります。</translation>
    </message>
    <message>
        <source>Restart the network…</source>
        <translation>ネットワークを再起動…</translation>
    </message>
    <message>
        <source>Module %1 received a garbled command and did not carry it out.</source>
        <translation>モジュール%1は化けたコマンドを受信し、実行しませんでした。</translation>
    </message>
    <message>
        <source>Sending again (%1 of 3). Usually noise on the cable.</source>
        <translation>再送信します（%1 / 3回）。多くの場合、ケーブルのノイズです。</translation>
    </message>
    <message>
        <source>The answer from module %1 was garbled.</source>
        <translation>モジュール%1からの応答が化けていました。</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; the panel is reading the position again.</source>
        <translation>コマンドが実行されたかどうかは不明です。パネルは位置を読み直しています。</translation>
    </message>
    <message>
        <source>Command byte %1</source>
        <translation>コマンドバイト%1</translation>
    </message>
    <message>
        <source>Module %1: done.</source>
        <translation>モジュール%1：完了。</translation>
    </message>
    <message>
        <source>Module %1 received the command garbled and did not carry it out.</source>
        <translation>モジュール%1は化けたコマンドを受信し、実行しませんでした。</translation>
    </message>
    <message>
        <source>Sent 3 times; later commands were not sent. Usually noise on the cable.</source>
        <translation>3回送信しました。以降のコマンドは送信していません。多くの場合、ケーブルのノイズです。</translation>
    </message>
    <message>
        <source>Module %1 did not answer the command. Motor state unknown.</source>
        <translation>モジュール%1がコマンドに応答しませんでした。モーターの状態は不明です。</translation>
    </message>
    <message>
        <source>The command may or may not have been carried out; later commands were not sent. Look at the motor; stop all if in doubt.</source>
        <translation>コマンドが実行されたかどうかは不明です。以降のコマンドは送信していません。モーターを目視で確認し、疑わしい場合は全停止してください。</translation>
    </message>
    <message>
        <source>Module %1 cannot do this in its present state. Nothing was sent.</source>
        <translation>モジュール%1は現在の状態ではこれを実行できません。何も送信していません。</translation>
    </message>
    <message>
        <source>Stop the motor, then try again.</source>
        <translation>モーターを停止してから、もう一度試してください。</translation>
    </message>
    <message>
        <source>The command for module %1 was cancelled.</source>
        <translation>モジュール%1へのコマンドは取り消されました。</translation>
    </message>
    <message>
        <source>Too many commands are waiting. Nothing was sent to module %1.</source>
        <translation>待機中のコマンドが多すぎます。モジュール %1 には何も送信していません。</translation>
    </message>
    <message>
        <source>Wait until they are carried out, or press STOP ALL to discard them.</source>
        <translation>実行されるまで待つか、全停止で破棄してください。</translation>
    </message>
    <message>
        <source>Module %1 switched its servo off because the motor was more than %2 counts from where it should be.</source>
        <translation>モーターがあるべき位置から%2カウントより大きくずれたため、モジュール%1がサーボをオフにしました。</translation>
    </message>
    <message>
        <source>Module %1 switched its servo off because the motor was too far from where it should be.</source>
        <translation>モーターがあるべき位置から大きくずれたため、モジュール%1がサーボをオフにしました。</translation>
    </message>
    <message>
        <source>Clear and stay off</source>
        <translation>クリア（オフのまま）</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its servo is off.</source>
        <translation>モジュール%1にモーター電源がないため、サーボはオフです。</translation>
    </message>
    <message>
        <source>It stays off when power returns.</source>
        <translation>電源が戻っても、オフのままです。</translation>
    </message>
    <message>
        <source>The computer was busy, or the program that jogs it has stopped calling. Press and hold again.</source>
        <translation>コンピューターが応答できなかったか、ジョグを行うプログラムが呼び出しを止めました。もう一度押し続けてください。</translation>
    </message>
    <message>
        <source>Module %1 cannot do this now; nothing was sent.</source>
        <translation>モジュール%1は今これを実行できません。何も送信していません。</translation>
    </message>
    <message>
        <source>reaches %1 of %2</source>
        <translation>%2台中%1台に届きます</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped before the port closes.</source>
        <translation>
            <numerusform>%n台のモーターが動いています。ポートを閉じる前に停止します。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopping the motors, then closing.</source>
        <translation>モーターを停止してから閉じます。</translation>
    </message>
    <message>
        <source>Fit a hardware emergency stop that removes motor power.</source>
        <translation>モーター電源を遮断するハードウェアの非常停止装置を設置してください。</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>了解</translation>
    </message>
    <message>
        <source>Module %1</source>
        <translation>モジュール%1</translation>
    </message>
    <message>
        <source>type %1</source>
        <translation>タイプ%1</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>Not asked</source>
        <translation>問い合わせ停止</translation>
    </message>
    <message>
        <source>No motor power</source>
        <translation>モーター電源なし</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>サーボオフ</translation>
    </message>
    <message>
        <source>Power was lost</source>
        <translation>電源喪失あり</translation>
    </message>
    <message>
        <source>PWM mode</source>
        <translation>PWMモード</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>保持中</translation>
    </message>
    <message>
        <source>Accelerating</source>
        <translation>加速中</translation>
    </message>
    <message>
        <source>At speed</source>
        <translation>定速中</translation>
    </message>
    <message>
        <source>Decelerating</source>
        <translation>減速中</translation>
    </message>
    <message>
        <source>No status received from this module yet.</source>
        <translation>このモジュールからはまだステータスを受信していません。</translation>
    </message>
    <message>
        <source>The module does not answer. Motor state unknown.</source>
        <translation>モジュールが応答しません。モーターの状態は不明です。</translation>
    </message>
    <message>
        <source>Sending has stopped because another module restarted, so what this one does now is not known. Scan again, or restart the network.</source>
        <translation>別のモジュールが再起動したため送信を中止しました。このモジュールの現在の動作は不明です。再スキャンするか、ネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>The motor is free to turn. This is normal: the servo is switched off.</source>
        <translation>モーターは自由に回ります。これは正常です。サーボがオフです。</translation>
    </message>
    <message>
        <source>The servo switched itself off because the motor was too far from where it should be.</source>
        <translation>モーターがあるべき位置から大きくずれたため、サーボが自動でオフになりました。</translation>
    </message>
    <message>
        <source>A fixed PWM value drives the motor; the servo does not control it. After a loss of motor power, the motor may turn again by itself.</source>
        <translation>固定のPWM値でモーターを駆動しています。サーボは制御していません。モーター電源が一度切れて戻ると、モーターがひとりでに再び回ることがあります。</translation>
    </message>
    <message>
        <source>The motor is changing its speed.</source>
        <translation>モーターが速度を変えています。</translation>
    </message>
    <message>
        <source>The motor moves at its goal velocity.</source>
        <translation>モーターは目標速度で動いています。</translation>
    </message>
    <message>
        <source>The motor is slowing down.</source>
        <translation>モーターは減速しています。</translation>
    </message>
    <message>
        <source>Not connected. Choose a port and connect first.</source>
        <translation>未接続です。先にポートを選択して接続してください。</translation>
    </message>
    <message>
        <source>This module is not a PIC-SERVO.</source>
        <translation>このモジュールはPIC-SERVOではありません。</translation>
    </message>
    <message>
        <source>The module does not answer, so its state is unknown.</source>
        <translation>モジュールが応答しないため、状態は不明です。</translation>
    </message>
    <message>
        <source>This is not the type of module that the machine has here, so its settings do not apply. Only stop commands work until you accept the chain as found (Chain doctor).</source>
        <translation>マシンがここに想定するモジュールとは種類が異なるため、その設定は適用されません。検出結果を採用する（チェーン診断）まで、停止だけが有効です。</translation>
    </message>
    <message>
        <source>The module has no motor power.</source>
        <translation>モジュールにモーター電源がありません。</translation>
    </message>
    <message>
        <source>The gains are 0 or unknown, so the motor would not hold. Apply gains first.</source>
        <translation>ゲインが0または不明のため、モーターは位置を保持できません。先にゲインを適用してください。</translation>
    </message>
    <message>
        <source>The servo is off. Enable it first.</source>
        <translation>サーボがオフです。先にオンにしてください。</translation>
    </message>
    <message>
        <source>The motor is moving. Stop it first: a move to a position starts from standstill.</source>
        <translation>モーターが動いています。先に停止してください。位置への移動は停止状態から始めます。</translation>
    </message>
    <message>
        <source>The acceleration is 0 or unknown: the motor might not start or stop. Enter an acceleration.</source>
        <translation>加速度が0または不明です。モーターが起動や停止をできないおそれがあります。加速度を入力してください。</translation>
    </message>
    <message>
        <source>The velocity is 0 or unknown: the motor might not move, or move too fast. Enter a velocity.</source>
        <translation>速度が0または不明です。モーターが動かない、または速すぎるおそれがあります。速度を入力してください。</translation>
    </message>
    <message>
        <source>The chip cannot turn the motor this slowly in its speed mode. Enter a higher velocity, or choose another speed mode.</source>
        <translation>チップは現在の速度モードではモーターをこれほど遅く回せません。より大きい速度を入力するか、別の速度モードを選んでください。</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>異常</translation>
    </message>
    <message>
        <source>restarting the modules</source>
        <translation>モジュールを再起動中</translation>
    </message>
    <message>
        <source>assigning addresses</source>
        <translation>アドレスを割り当て中</translation>
    </message>
    <message>
        <source>reading types and versions</source>
        <translation>タイプとバージョンを読み出し中</translation>
    </message>
    <message>
        <source>changing the baud rate</source>
        <translation>ボーレートを変更中</translation>
    </message>
    <message>
        <source>setting up status reports</source>
        <translation>ステータス報告を設定中</translation>
    </message>
    <message>
        <source>Simulator (%1)</source>
        <translation>シミュレーター (%1)</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未接続</translation>
    </message>
    <message>
        <source>Connecting to %1: %2</source>
        <translation>%1に接続中：%2</translation>
    </message>
    <message>
        <source>%1, %2 so far</source>
        <translation>%1、これまでに%2</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3</source>
        <translation>%1に接続済み、%2 Bd、%3</translation>
    </message>
    <message>
        <source>%1 is open, but no module is usable</source>
        <translation>%1は開いていますが、使用できるモジュールがありません</translation>
    </message>
    <message>
        <source>Connection to %1 lost, motor state unknown</source>
        <translation>%1との接続が切れました。モーターの状態は不明です</translation>
    </message>
    <message>
        <source>Sending to %1 has stopped: module %2 restarted</source>
        <translation>%1への送信を中止しました：モジュール%2が再起動しました</translation>
    </message>
    <message numerus="yes">
        <source>%n modules</source>
        <translation>
            <numerusform>モジュール%n台</numerusform>
        </translation>
    </message>
    <message>
        <source> and </source>
        <translation>と</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>カウント</translation>
    </message>
    <message>
        <source>counts/tick</source>
        <translation>カウント/周期</translation>
    </message>
    <message>
        <source>counts/tick²</source>
        <translation>カウント/周期²</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>完了：%1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>失敗：%1</translation>
    </message>
    <message>
        <source>Answer to: %1</source>
        <translation>%1への応答</translation>
    </message>
    <message>
        <source>Two modules on %1 have the same address, so the modules cannot be used.</source>
        <translation>%1の2台のモジュールが同じアドレスのため、モジュールを使用できません。</translation>
    </message>
    <message>
        <source>No motor was moved. Usually two ADDR_IN inputs are grounded; ground only that of the module farthest from the PC.</source>
        <translation>モーターは動かしていません。多くの場合、2つのADDR_IN入力が接地されています。PCから最も遠いモジュールだけを接地してください。</translation>
    </message>
    <message>
        <source>The line at %1 is held low: only zero bytes arrive.</source>
        <translation>%1の回線がLowに固定されています。0のバイトしか届きません。</translation>
    </message>
    <message>
        <source>Motor state unknown; commands may not get through. Usually a short circuit, swapped wires of a pair, or a module without power.</source>
        <translation>モーターの状態は不明です。コマンドが届かない可能性があります。多くの場合、短絡、ペア線の逆接続、または電源の入っていないモジュールです。</translation>
    </message>
    <message>
        <source>The modules on %1 have no addresses yet.</source>
        <translation>%1のモジュールにはまだアドレスがありません。</translation>
    </message>
    <message>
        <source>A read-only connection cannot assign addresses. Choose Connect fully.</source>
        <translation>読み取り専用接続ではアドレスを割り当てられません。読み取り専用を使わずに接続してください。</translation>
    </message>
    <message>
        <source>The link is marginal: %1 of the last %2 exchanges failed.</source>
        <translation>通信の信頼性に疑いがあります。直近%2回の通信のうち%1回が失敗しました。</translation>
    </message>
    <message>
        <source>Motor state unknown. Look at the motor; stop all if in doubt.</source>
        <translation>モーターの状態は不明です。モーターを目視で確認し、疑わしい場合は全停止してください。</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1分</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1時間</translation>
    </message>
    <message>
        <source>The panel froze for %1 while a motor was moving. The motor was not stopped.</source>
        <translation>モーターが動いているときに、パネルが%1応答しませんでした。モーターへの停止指令は送られていません。</translation>
    </message>
    <message>
        <source>STOP ALL did not work during that time. The computer was busy, or the program hung.</source>
        <translation>その間、全停止は効きませんでした。コンピューターの負荷が高かったか、プログラムがハングしていました。</translation>
    </message>
    <message>
        <source>Resumed after %1: reading all values again.</source>
        <translation>%1後に復帰しました。すべての値を読み直しています。</translation>
    </message>
    <message>
        <source>Resumed after %1: motors were commanded to stop; reading all values again.</source>
        <translation>%1後に復帰しました。モーターに停止を指令し、すべての値を読み直しています。</translation>
    </message>
    <message>
        <source>While the computer was suspended, the panel could not stop a motor. Look at the motors before the next move.</source>
        <translation>コンピューターのスリープ中、パネルはモーターを停止できませんでした。次の移動の前にモーターを目視で確認してください。</translation>
    </message>
    <message numerus="yes">
        <source>The last session ended while motors %1 were moving.</source>
        <translation>
            <numerusform>前回のセッションは、モーター%1が動いている間に終了しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Settings cannot be saved.</source>
        <translation>設定を保存できません。</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works; only the window layout and the last port are not remembered.</source>
        <translation>%1に書き込めません。ウィンドウのレイアウトと最後のポートが保存されないだけで、ほかはすべて動作します。</translation>
    </message>
    <message>
        <source>%1 is used by another program (pid %2).</source>
        <translation>%1は別のプログラムが使用中です（PID %2）。</translation>
    </message>
    <message>
        <source>%1 is used by %2 (pid %3).</source>
        <translation>%1は%2が使用中です（PID %3）。</translation>
    </message>
    <message>
        <source>It probes a newly connected adapter for a modem for a few seconds; wait, then try again. To keep it away from USB adapters, run %1, then plug the adapter in again.</source>
        <translation>このプログラムは、新しく接続されたアダプターにモデムがないか数秒間調べます。待ってから、もう一度試してください。USBアダプターを調べさせないようにするには、%1を実行し、アダプターを差し直してください。</translation>
    </message>
    <message>
        <source>It mistakes many serial adapters for a Braille display. If you have none, run %1, then plug the adapter in again.</source>
        <translation>このプログラムは、多くのシリアルアダプターを点字ディスプレイと誤認します。点字ディスプレイを使っていない場合は、%1を実行し、アダプターを差し直してください。</translation>
    </message>
    <message>
        <source>%1 is free, but a stale lock file marks it as in use.</source>
        <translation>%1は空いていますが、古いロックファイルのために使用中と見なされています。</translation>
    </message>
    <message>
        <source>%2 left the lock file %1 behind. Remove it with %3, then try again.</source>
        <translation>%2がロックファイル%1を残しました。%3で削除してから、もう一度試してください。</translation>
    </message>
    <message>
        <source>Could not open %1: no lock file can be created for it.</source>
        <translation>%1を開けませんでした。ロックファイルを作成できません。</translation>
    </message>
    <message>
        <source>Your user account has no write access to %1 or any other folder for lock files. Ask your system administrator for access.</source>
        <translation>お使いのユーザーアカウントには、%1にもロックファイル用のほかのフォルダーにも書き込み権限がありません。システム管理者に権限を依頼してください。</translation>
    </message>
    <message>
        <source>Could not open %1: this program has too many open files.</source>
        <translation>%1を開けませんでした。このプログラムが開いているファイルが多すぎます。</translation>
    </message>
    <message>
        <source>Close files that you do not need, or restart the program.</source>
        <translation>不要なファイルを閉じるか、プログラムを再起動してください。</translation>
    </message>
    <message>
        <source>Set the latency timer of the USB adapter to 1 ms, then connect again.</source>
        <translation>USBアダプターのレイテンシタイマーを1 msに設定し、接続し直してください。</translation>
    </message>
    <message>
        <source>Run %1. This lasts until the adapter is unplugged. To make it permanent, also run %2.</source>
        <translation>%1を実行してください。アダプターを抜くまで有効です。恒久的に設定するには、%2も実行してください。</translation>
    </message>
    <message>
        <source>The adapter is back as %1 (same serial number). Reconnect?</source>
        <translation>アダプターが%1として再び見つかりました（同じシリアル番号）。再接続しますか？</translation>
    </message>
    <message>
        <source>A similar adapter was found as %1. Reconnect?</source>
        <translation>同種のアダプターが%1として見つかりました。再接続しますか？</translation>
    </message>
    <message>
        <source>Motors may still be moving. Reconnecting moves nothing and repeats no earlier command.</source>
        <translation>モーターがまだ動いている可能性があります。再接続しても何も動かず、以前のコマンドも再送されません。</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (19 200 Bd tried).</source>
        <translation>ポートは開いていますが、応答したモジュールはありません（19 200 Bdを試行）。</translation>
    </message>
    <message>
        <source>The port is open, but no module answered (9600, 19 200, 57 600 and 115 200 Bd tried).</source>
        <translation>ポートは開いていますが、応答したモジュールはありません（9600、19 200、57 600、115 200 Bdを試行）。</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex (4-wire) adapter. If another program left the chain at an unusual baud rate, restart the network.</source>
        <translation>次の順に確認してください：モジュールの電源、チェーンの全ケーブル（1本の緩みですべてのモジュールが見えなくなります）、PCから最も遠いモジュールのADDR_INジャンパー、TXとRXが入れ替わっていないこと、全二重（4線式）アダプターであること。別のプログラムがチェーンを通常と異なるボーレートのままにした場合は、ネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>Connected to %1: %2 at %3 Bd, left running.</source>
        <translation>%1に接続しました。%2、%3 Bd、動作はそのままです。</translation>
    </message>
    <message>
        <source>The modules carry on with what they were doing.</source>
        <translation>モジュールはそれまでの動作を続けます。</translation>
    </message>
    <message>
        <source>Gains are unknown until you apply them. Stop a motor before you move it: its last command is unknown.</source>
        <translation>ゲインは、適用するまで不明です。動かす前にモーターを停止してください。最後のコマンドが不明なためです。</translation>
    </message>
    <message>
        <source>A module without an address also answered; it cannot be used yet.</source>
        <translation>アドレスのないモジュールも応答しました。このモジュールはまだ使用できません。</translation>
    </message>
    <message>
        <source>Its motor is off. Either a module has restarted, or a new one was added. Restart the network to give it an address.</source>
        <translation>そのモーターはオフです。モジュールが再起動したか、新しいモジュールが追加されました。アドレスを割り当てるには、ネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>The link to module %1 is unreliable: %2 of its last %3 exchanges failed.</source>
        <translation>モジュール%1との通信が不安定です。直近%3回の通信のうち%2回が失敗しました。</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>再接続</translation>
    </message>
    <message>
        <source>A different adapter is on %1.</source>
        <translation>%1に別のアダプターが接続されています。</translation>
    </message>
    <message>
        <source>The panel was connected to another adapter before. Nothing was sent.</source>
        <translation>以前に接続していたアダプターとは異なります。何も送信していません。</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>それでも接続</translation>
    </message>
    <message>
        <source>The link to module %1 is marginal: %2 of its last %3 exchanges failed.</source>
        <translation>モジュール%1との通信の信頼性に疑いがあります。直近%3回の通信のうち%2回が失敗しました。</translation>
    </message>
    <message>
        <source>Its motor is off.</source>
        <translation>そのモーターはオフです。</translation>
    </message>
    <message>
        <source>Set its outputs again once it has its address.</source>
        <translation>アドレスが戻ったら、出力を設定し直してください。</translation>
    </message>
    <message>
        <source>Every module loses its position, gains and address, and switches its motor off.</source>
        <translation>すべてのモジュールが位置、ゲイン、アドレスを失い、モーターをオフにします。</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving. They will be stopped first.</source>
        <translation>
            <numerusform>%n台のモーターが動いています。先に停止します。</numerusform>
        </translation>
    </message>
    <message>
        <source>Restarted</source>
        <translation>再起動しました</translation>
    </message>
    <message>
        <source>The module restarted: its motor is off, and its position, gains and address are lost. Assign its address again if offered, or restart the network.</source>
        <translation>モジュールが再起動しました。モーターはオフで、位置、ゲイン、アドレスは失われました。アドレスの再割り当てが提示された場合は実行し、提示されない場合はネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>The module restarted: its pins are inputs again, its outputs release what they drove, and its address is lost. Assign its address again if offered, or restart the network.</source>
        <translation>モジュールが再起動しました。ピンは入力に戻り、出力は駆動をやめ、アドレスは失われました。アドレスの再割り当てが提示された場合は実行し、提示されない場合はネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>The module restarted: its motor is off, and its position, parameters and address are lost. Assign its address again if offered, or restart the network.</source>
        <translation>モジュールが再起動しました。モーターはオフで、位置、パラメーター、アドレスは失われました。アドレスの再割り当てが提示された場合は実行し、提示されない場合はネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>all bytes are 00, or all FF, as on a line that is held low or high</source>
        <translation>全バイトが00または全バイトがFF（回線がLowまたはHighに固定されたときと同じ）</translation>
    </message>
    <message>
        <source>more bytes than requested</source>
        <translation>要求より多いバイト</translation>
    </message>
    <message>
        <source>type or version does not match this module</source>
        <translation>タイプまたはバージョンがこのモジュールと一致しない</translation>
    </message>
    <message>
        <source>an undefined status bit changed</source>
        <translation>未定義のステータスビットが変化</translation>
    </message>
    <message>
        <source>homing started without a command</source>
        <translation>コマンドなしで原点復帰が開始</translation>
    </message>
    <message>
        <source>home register changed without a command</source>
        <translation>コマンドなしで原点レジスターが変化</translation>
    </message>
    <message>
        <source>position jumped farther than the velocities allow</source>
        <translation>位置が速度上あり得ない距離だけ変化</translation>
    </message>
    <message>
        <source>velocity changed faster than any motor can</source>
        <translation>速度がモーターではあり得ない速さで変化</translation>
    </message>
    <message>
        <source>servo is off, but pos_error or move_done is not set</source>
        <translation>サーボオフなのにpos_errorまたはmove_doneがセットされていない</translation>
    </message>
    <message>
        <source>servo is on without motor power</source>
        <translation>モーター電源なしでサーボがオン</translation>
    </message>
    <message>
        <source>slew_done is set without accel_done</source>
        <translation>accel_doneなしでslew_doneがセット</translation>
    </message>
    <message>
        <source>a sticky bit was cleared without a command</source>
        <translation>コマンドなしでスティッキービットがクリア</translation>
    </message>
    <message>
        <source>velocity and trapezoidal mode at once</source>
        <translation>速度モードと台形モードが同時</translation>
    </message>
    <message>
        <source>moving without power or amplifier</source>
        <translation>電源またはアンプなしで移動</translation>
    </message>
    <message>
        <source>position changed while the motor was stopped</source>
        <translation>モーター停止中に位置が変化</translation>
    </message>
    <message>
        <source>timer count of a moving motor is not 1 to 65 452</source>
        <translation>動いているモーターのタイマー値が1～65 452の範囲外</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>受理</translation>
    </message>
    <message>
        <source>module refused: checksum</source>
        <translation>モジュールが拒否：チェックサム</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>too few bytes</source>
        <translation>バイト不足</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>チェックサム不一致</translation>
    </message>
    <message>
        <source>rejected: %1</source>
        <translation>棄却：%1</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>棄却</translation>
    </message>
    <message>
        <source>cancelled by a stop</source>
        <translation>停止のため取り消し</translation>
    </message>
    <message>
        <source>no answer expected</source>
        <translation>応答は不要</translation>
    </message>
    <message>
        <source>bytes, but no answer was expected</source>
        <translation>応答不要なのにバイトを受信</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>poll</source>
        <translation>ポーリング</translation>
    </message>
    <message>
        <source>command</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>check</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>challenge</source>
        <translation>検証</translation>
    </message>
    <message>
        <source>flush</source>
        <translation>フラッシュ</translation>
    </message>
    <message>
        <source>Address %1</source>
        <translation>アドレス%1</translation>
    </message>
    <message>
        <source>SIMULATED SESSION: no hardware was connected.</source>
        <translation>シミュレーションセッション：ハードウェアは接続されていませんでした。</translation>
    </message>
    <message>
        <source>Packets of %1 on %2, seconds since %3</source>
        <translation>%1のパケット（%2）、%3からの秒数</translation>
    </message>
    <message>
        <source>Older exchanges left out of this file: %1.</source>
        <translation>このファイルに含まれない古い通信：%1。</translation>
    </message>
    <message>
        <source>Exchanges before this one were not recorded.</source>
        <translation>これより前の通信は記録されていません。</translation>
    </message>
    <message>
        <source>looking for modules</source>
        <translation>モジュールを検索中</translation>
    </message>
    <message>
        <source>Carried out by: %1.</source>
        <translation>実行済み：%1。</translation>
    </message>
    <message>
        <source>Not carried out by: %1.</source>
        <translation>未実行：%1。</translation>
    </message>
    <message>
        <source>Unknown for: %1.</source>
        <translation>不明：%1。</translation>
    </message>
    <message>
        <source>No answer from: %1.</source>
        <translation>応答なし：%1。</translation>
    </message>
    <message>
        <source>%1 of %2 modules of group %3 started. All of them were commanded to stop.</source>
        <translation>グループ%3の%2台中%1台のモジュールが開始しました。全台に停止を指令しました。</translation>
    </message>
    <message>
        <source>No module of group %1 started. Nothing was moved.</source>
        <translation>グループ%1のモジュールは1台も開始しませんでした。何も動かしていません。</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed their start.</source>
        <translation>グループ%1に、開始を確認応答していないモジュールがあります。</translation>
    </message>
    <message>
        <source>Look at the motors. The start is never repeated: load the moves again, then start the group again. Usually noise on the cable.</source>
        <translation>モーターを目視で確認してください。開始は再送されません。もう一度ロードしてから開始してください。多くの場合、ケーブルのノイズです。</translation>
    </message>
    <message>
        <source>Group %1 is empty. Nothing was sent.</source>
        <translation>グループ%1は空です。何も送信していません。</translation>
    </message>
    <message>
        <source>Add modules to the group first.</source>
        <translation>先にモジュールをグループに追加してください。</translation>
    </message>
    <message>
        <source>Module %2 blocks the command to group %1. Nothing was sent.</source>
        <translation>モジュール%2のため、グループ%1へのコマンドを実行できません。何も送信していません。</translation>
    </message>
    <message>
        <source>A group starts only when every member answers, has confirmed its load and can start, and the group of every module is known. Load this module again, or set its group again.</source>
        <translation>グループを開始できるのは、全メンバーが応答し、ロードを確認応答して開始可能であり、全モジュールのグループが分かっている場合だけです。このモジュールをもう一度ロードするか、グループを設定し直してください。</translation>
    </message>
    <message>
        <source>Module %1 did not confirm its new group, so its group is unknown.</source>
        <translation>モジュール%1が新しいグループを確認応答しなかったため、グループは不明です。</translation>
    </message>
    <message>
        <source>Could not change the group of module %1.</source>
        <translation>モジュール%1のグループを変更できませんでした。</translation>
    </message>
    <message>
        <source>Nothing was moved. A group has at most one leader, group FF has none, and the groups of all modules must be known. Check this, then try again.</source>
        <translation>何も動かしていません。リーダーは1グループに1台まで、グループFFにはリーダーを置けません。また、全モジュールのグループが分かっている必要があります。確認してから、もう一度試してください。</translation>
    </message>
    <message>
        <source>The command to group %1 was cancelled.</source>
        <translation>グループ%1へのコマンドは取り消されました。</translation>
    </message>
    <message>
        <source>Too many commands are waiting. Nothing was sent to group %1.</source>
        <translation>待機中のコマンドが多すぎます。グループ %1 には何も送信していません。</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed saving home.</source>
        <translation>グループ%1に、原点の保存を確認応答していないモジュールがあります。</translation>
    </message>
    <message>
        <source>No motor was moved.</source>
        <translation>モーターは動かしていません。</translation>
    </message>
    <message>
        <source>A PIC-I/O confirms latched inputs and stored PWM values only as the leader: make it the leader of the group.</source>
        <translation>PIC-I/Oは、ラッチした入力と保存したPWM値をリーダーのときだけ確認できます。グループのリーダーにしてください。</translation>
    </message>
    <message>
        <source>All modules now run at %1 Bd. Positions and gains are unchanged.</source>
        <translation>全モジュールが%1 Bdで動作しています。位置とゲインは変わりません。</translation>
    </message>
    <message>
        <source>Could not change the baud rate: the chain stays at %1 Bd. No motor was moved.</source>
        <translation>ボーレートを変更できませんでした。チェーンは%1 Bdのままです。モーターは動かしていません。</translation>
    </message>
    <message>
        <source>The modules do not support %1 Bd. Choose another baud rate.</source>
        <translation>モジュールは%1 Bdに対応していません。別のボーレートを選択してください。</translation>
    </message>
    <message>
        <source>A motor is moving, or about to move. Stop all motors, then try again.</source>
        <translation>モーターが動いているか、動き出そうとしています。すべてのモーターを停止してから、もう一度試してください。</translation>
    </message>
    <message>
        <source>Module %1 does not answer and would be left behind. Connect again first.</source>
        <translation>モジュール%1が応答しないため、取り残されます。先に接続し直してください。</translation>
    </message>
    <message>
        <source>Another program may have changed the group of module %1, which would then miss the new baud rate. Set its group again, or restart the network.</source>
        <translation>別のプログラムがモジュール%1のグループを変えた可能性があり、その場合は新しいボーレートが伝わりません。グループを設定し直すか、ネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>Module %1 is a group leader and would answer at the new baud rate. Make it an ordinary member first.</source>
        <translation>モジュール%1はグループリーダーのため、新しいボーレートで応答してしまいます。先に通常のメンバーにしてください。</translation>
    </message>
    <message>
        <source>Module %2 did not answer at %1 Bd, so all modules went back to the old rate. Try another baud rate, a shorter cable, or termination at both ends.</source>
        <translation>モジュール%2が%1 Bdで応答しなかったため、全モジュールを元に戻しました。別のボーレート、短いケーブル、または両端の終端を試してください。</translation>
    </message>
    <message>
        <source>A stop took priority.</source>
        <translation>停止が先に実行されました。</translation>
    </message>
    <message>
        <source>Module %1 has not answered since the baud rate changed. No motor was moving.</source>
        <translation>ボーレートの変更後、モジュール%1が応答していません。動いていたモーターはありません。</translation>
    </message>
    <message>
        <source>It may still be at %1 Bd; the others are at %2 Bd. Scan again. If the module is not found, restart the network: positions and gains are lost.</source>
        <translation>このモジュールはまだ%1 Bdの可能性があります。ほかは%2 Bdです。再スキャンしてください。見つからない場合はネットワークを再起動してください。位置とゲインは失われます。</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>text in quotation marks</source>
        <translation>引用符で囲んだ文字列</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>trueまたはfalse</translation>
    </message>
    <message>
        <source>an object in { }</source>
        <translation>{ }で囲んだオブジェクト</translation>
    </message>
    <message>
        <source>a list in [ ]</source>
        <translation>[ ]で囲んだリスト</translation>
    </message>
    <message>
        <source>the file is incomplete.</source>
        <translation>ファイルが途中で終わっています。</translation>
    </message>
    <message>
        <source>this text is not UTF-8.</source>
        <translation>このテキストはUTF-8ではありません。</translation>
    </message>
    <message>
        <source>this is not JSON.</source>
        <translation>JSONではありません。</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1は数値ではありません。</translation>
    </message>
    <message>
        <source>this number is too large.</source>
        <translation>数値が大きすぎます。</translation>
    </message>
    <message>
        <source>more than %1 levels of brackets.</source>
        <translation>括弧が%1段を超えて入れ子になっています。</translation>
    </message>
    <message>
        <source>more than %1 values.</source>
        <translation>値が%1個を超えています。</translation>
    </message>
    <message>
        <source>%1 appears twice.</source>
        <translation>%1が重複しています。</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1がありません。</translation>
    </message>
    <message>
        <source>%1 is not %2.</source>
        <translation>%1が%2ではありません。</translation>
    </message>
    <message>
        <source>%1 is %2; it must be %3 to %4.</source>
        <translation>%1は%2です。%3～%4でなければなりません。</translation>
    </message>
    <message>
        <source>%1 has the unknown value &quot;%2&quot;.</source>
        <translation>%1の値「%2」は不明です。</translation>
    </message>
    <message>
        <source>%1 has an unprintable character.</source>
        <translation>%1に印刷できない文字があります。</translation>
    </message>
    <message>
        <source>%1 has more than %2 entries.</source>
        <translation>%1の項目が%2個を超えています。</translation>
    </message>
    <message>
        <source>%1 has a unit that does not fit the module of this axis.</source>
        <translation>%1の単位がこの軸のモジュールに合いません。</translation>
    </message>
    <message>
        <source>module %1 is already in a group.</source>
        <translation>モジュール%1はすでにグループに属しています。</translation>
    </message>
    <message>
        <source>another group also has address %1.</source>
        <translation>別のグループもアドレス%1を使用しています。</translation>
    </message>
    <message>
        <source>the leader is not one of the group&apos;s modules.</source>
        <translation>リーダーがグループのモジュールに含まれていません。</translation>
    </message>
    <message>
        <source>There is no file %1. Check whether it was moved, or its disk is disconnected.</source>
        <translation>ファイル%1がありません。移動されたか、ディスクが取り外されていないか確認してください。</translation>
    </message>
    <message>
        <source>The folder %1 does not exist. Choose another one.</source>
        <translation>フォルダー%1がありません。別のフォルダーを選択してください。</translation>
    </message>
    <message>
        <source>This is a folder or a device. Choose a file.</source>
        <translation>これはフォルダーまたはデバイスです。ファイルを選択してください。</translation>
    </message>
    <message>
        <source>Your user account has no permission for %1. Choose another folder, or change the permissions.</source>
        <translation>お使いのユーザーアカウントには%1の権限がありません。別のフォルダーを選択するか、権限を変更してください。</translation>
    </message>
    <message>
        <source>The disk of %1 is read-only. Choose another folder.</source>
        <translation>%1のディスクは読み取り専用です。別のフォルダーを選択してください。</translation>
    </message>
    <message>
        <source>The disk of %1 is full. Free some space, or choose another folder.</source>
        <translation>%1のディスクに空きがありません。空きを増やすか、別のフォルダーを選択してください。</translation>
    </message>
    <message>
        <source>It is larger than any machine file. Check that it is the right file.</source>
        <translation>マシンファイルとしては大きすぎます。正しいファイルか確認してください。</translation>
    </message>
    <message>
        <source>Another program has changed it since it was opened or saved here. Open it to see the changes, or save as another file; saving as the same one replaces it.</source>
        <translation>ここで開くか保存した後に、別のプログラムがこのファイルを変更しました。変更を見るにはファイルを開き、両方を残すには別の名前で保存してください。同じ名前で保存すると置き換えられます。</translation>
    </message>
    <message>
        <source>See Details for the system&apos;s message.</source>
        <translation>システムのメッセージは「詳細」を参照してください。</translation>
    </message>
    <message>
        <source>counts (steps)</source>
        <translation>カウント（ステップ）</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>custom unit</source>
        <translation>独自の単位</translation>
    </message>
    <message>
        <source>abruptly</source>
        <translation>即停止</translation>
    </message>
    <message>
        <source>smoothly</source>
        <translation>減速停止</translation>
    </message>
    <message>
        <source>motor off</source>
        <translation>モーターオフ</translation>
    </message>
    <message>
        <source>an unnamed machine</source>
        <translation>名前のないマシン</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty.</source>
        <translation>「%1」は空です。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than %2 bytes.</source>
        <translation>「%1」が%2バイトを超えています。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a machine file of NMC Panel.</source>
        <translation>「%1」はNMC Panelのマシンファイルではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was written by a newer NMC Panel: its format is %2; this version reads formats up to %3.</source>
        <translation>「%1」は新しいバージョンのNMC Panelで作成されました。形式は%2ですが、このバージョンが読める形式は%3までです。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; line %2: %3</source>
        <translation>「%1」%2行目：%3</translation>
    </message>
    <message>
        <source>Nothing was loaded.</source>
        <translation>何も読み込んでいません。</translation>
    </message>
    <message>
        <source>Could not open &quot;%1&quot;.</source>
        <translation>「%1」を開けませんでした。</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;. Its previous content is kept.</source>
        <translation>「%1」を保存できませんでした。元の内容は残っています。</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;: it could not be opened again afterwards.</source>
        <translation>「%1」を保存できませんでした。保存後に開き直すことができません。</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>何も送信していません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. No differences.</source>
        <translation>「%1」を開きました。違いはありません。</translation>
    </message>
    <message>
        <source>Nothing was applied.</source>
        <translation>何も適用されませんでした。</translation>
    </message>
    <message>
        <source>Modules or settings have changed since the table was shown, so it was updated. Check it, then apply again.</source>
        <translation>表を表示した後にモジュールまたは設定が変わったため、表を更新しました。確認してから、もう一度適用してください。</translation>
    </message>
    <message>
        <source>An earlier session left unsaved changes to %1.</source>
        <translation>以前のセッションで保存されなかった%1の変更があります。</translation>
    </message>
    <message>
        <source>If modules are connected, Restore shows what would change. Nothing is sent before you choose Apply.</source>
        <translation>モジュールが接続されている場合、「復元」で変更される内容が表示されます。「適用」を選ぶまで何も送信されません。</translation>
    </message>
    <message>
        <source>Discard: the changes are lost</source>
        <translation>破棄：変更は失われます</translation>
    </message>
    <message>
        <source>Could not recover unsaved changes of an earlier session.</source>
        <translation>以前のセッションの未保存の変更を回復できませんでした。</translation>
    </message>
    <message>
        <source>unsaved changes</source>
        <translation>未保存の変更</translation>
    </message>
    <message>
        <source>Changes to the machine are not backed up until you save them.</source>
        <translation>マシンの変更は、保存するまでバックアップされません。</translation>
    </message>
    <message>
        <source>%1 is not writable.</source>
        <translation>%1に書き込めません。</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>%1の変更を保存しますか？</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>マシン</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>原点復帰</translation>
    </message>
    <message>
        <source>A/D scale</source>
        <translation>A/Dスケール</translation>
    </message>
    <message>
        <source>Names of inputs and outputs</source>
        <translation>入出力の名前</translation>
    </message>
    <message>
        <source>Acceleration time</source>
        <translation>加速時間</translation>
    </message>
    <message>
        <source>Limit pins</source>
        <translation>リミットピン</translation>
    </message>
    <message>
        <source>Baud rate, Bd</source>
        <translation>ボーレート、Bd</translation>
    </message>
    <message>
        <source>Type and version</source>
        <translation>タイプとバージョン</translation>
    </message>
    <message>
        <source>Counts (steps) per unit</source>
        <translation>1単位のカウント（ステップ）数</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>記号</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Run velocity</source>
        <translation>運転速度</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>ジョグ速度</translation>
    </message>
    <message>
        <source>Max jog speed</source>
        <translation>最高ジョグ速度</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>On limit switch 1</source>
        <translation>リミットスイッチ1で検出</translation>
    </message>
    <message>
        <source>On limit switch 2</source>
        <translation>リミットスイッチ2で検出</translation>
    </message>
    <message>
        <source>On index</source>
        <translation>インデックスで検出</translation>
    </message>
    <message>
        <source>On position error</source>
        <translation>位置偏差で検出</translation>
    </message>
    <message>
        <source>On current limit</source>
        <translation>電流制限で検出</translation>
    </message>
    <message>
        <source>On home switch</source>
        <translation>原点スイッチで検出</translation>
    </message>
    <message>
        <source>Then on index</source>
        <translation>続いてインデックスで検出</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>逆方向</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>インデックス速度</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Search distance</source>
        <translation>サーチ距離</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>制限時間</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>原点へ移動</translation>
    </message>
    <message>
        <source>Set position to 0</source>
        <translation>位置を0に設定</translation>
    </message>
    <message>
        <source>Per A/D count</source>
        <translation>A/D 1カウントあたり</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>0のときの値</translation>
    </message>
    <message>
        <source>A/D unit</source>
        <translation>A/D単位</translation>
    </message>
    <message>
        <source>EL, counts</source>
        <translation>EL、カウント</translation>
    </message>
    <message>
        <source>Limit 1 is an input</source>
        <translation>リミットピン1が入力</translation>
    </message>
    <message>
        <source>Limit 2 is an input</source>
        <translation>リミットピン2が入力</translation>
    </message>
    <message>
        <source>Limit 1 as an output</source>
        <translation>リミットピン1の出力</translation>
    </message>
    <message>
        <source>Limit 2 as an output</source>
        <translation>リミットピン2の出力</translation>
    </message>
    <message>
        <source>Speed mode</source>
        <translation>速度モード</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>最小プロファイル速度</translation>
    </message>
    <message>
        <source>Run current</source>
        <translation>運転電流</translation>
    </message>
    <message>
        <source>Hold current</source>
        <translation>保持電流</translation>
    </message>
    <message>
        <source>Thermal limit</source>
        <translation>温度制限</translation>
    </message>
    <message>
        <source>Ignore limit switches</source>
        <translation>リミットスイッチを無視</translation>
    </message>
    <message>
        <source>Ignore E-stop input</source>
        <translation>E-stop入力を無視</translation>
    </message>
    <message>
        <source>Motor off on limit or E-stop input</source>
        <translation>リミットまたはE-stop入力でモーターオフ</translation>
    </message>
    <message>
        <source>Output %1</source>
        <translation>出力%1</translation>
    </message>
    <message>
        <source>Input %1</source>
        <translation>入力%1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Another type of module: if any of this axis is applied, the rest is reset.</source>
        <translation>モジュールの種類が異なります。この軸の一部でも適用すると、残りはリセットされます。</translation>
    </message>
    <message>
        <source>Changes only the panel; nothing is sent.</source>
        <translation>パネルだけが変わり、何も送信されません。</translation>
    </message>
    <message>
        <source>Sent to the module.</source>
        <translation>モジュールに送信されます。</translation>
    </message>
    <message>
        <source>Filled in, not sent: %1</source>
        <translation>入力済み、未送信：%1</translation>
    </message>
    <message>
        <source>Filled in, not sent.</source>
        <translation>入力済み、未送信。</translation>
    </message>
    <message>
        <source>Not in the file: stays as it is.</source>
        <translation>ファイルにないため、変わりません。</translation>
    </message>
    <message numerus="yes">
        <source>%n motors are moving: stop them before anything is sent.</source>
        <translation>
            <numerusform>%n台のモーターが動いています。送信する前に停止してください。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was stopped: its switch stayed active while backing off.</source>
        <translation>%1を停止しました。退避中もスイッチがオンのままだったためです。</translation>
    </message>
    <message>
        <source>The switch may be stuck, or the search direction is wrong. Move the motor off the switch, or change the direction, then try again.</source>
        <translation>スイッチが固着しているか、サーチ方向が間違っている可能性があります。モーターをスイッチから離すか方向を変えて、もう一度試してください。</translation>
    </message>
    <message>
        <source>%1 stopped before it found home.</source>
        <translation>%1は原点を検出する前に停止しました。</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input ended the motion. Check the search direction and the switches, then try again.</source>
        <translation>リミットスイッチまたはE-stop入力で動作が終了しました。サーチ方向とスイッチを確認して、もう一度試してください。</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within the search distance.</source>
        <translation>%1を停止しました。サーチ距離内に原点が見つからなかったためです。</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the search direction and the search distance.</source>
        <translation>スイッチとケーブル、サーチ方向、サーチ距離を確認してください。</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within the time limit.</source>
        <translation>%1を停止しました。制限時間内に原点が見つからなかったためです。</translation>
    </message>
    <message>
        <source>Check the switch and its cable, the search direction and velocity, and the time limit.</source>
        <translation>スイッチとケーブル、サーチの方向と速度、制限時間を確認してください。</translation>
    </message>
    <message>
        <source>%1 is not homed and was commanded to stop: the link was unreliable.</source>
        <translation>%1は原点復帰しておらず、停止を指令しました。通信が不安定だったためです。</translation>
    </message>
    <message>
        <source>The home position found may be wrong. Check the link, then repeat the search.</source>
        <translation>検出した原点が間違っている可能性があります。通信を確認して、サーチをやり直してください。</translation>
    </message>
    <message>
        <source>%1 is not homed and does not answer. Motor state unknown.</source>
        <translation>%1は原点復帰しておらず、応答しません。モーターの状態は不明です。</translation>
    </message>
    <message>
        <source>It was commanded to stop. Use the hardware stop if it moves.</source>
        <translation>停止を指令しました。モーターが動く場合はハードウェア停止装置を使用してください。</translation>
    </message>
    <message>
        <source>%1 is not homed: its motor switched itself off and is free to turn.</source>
        <translation>%1は原点復帰していません。モーターは自動でオフになり、自由に回ります。</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, enable the motor, then repeat the search.</source>
        <translation>位置偏差が大きすぎたか、モーター電源が失われました。引っ掛かりがないか確認し、モーターをオンにしてから、サーチをやり直してください。</translation>
    </message>
    <message>
        <source>%1 is not homed and was commanded to stop: a command failed, or its answer was lost.</source>
        <translation>%1は原点復帰しておらず、停止を指令しました。コマンドが失敗したか、その応答が失われたためです。</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Repeat the search.</source>
        <translation>多くの場合、ケーブルのノイズです。サーチをやり直してください。</translation>
    </message>
    <message>
        <source>%1 is at rest but not homed: two readings of home differ.</source>
        <translation>%1は停止していますが、原点復帰していません。原点の2回の読み取り値が異なるためです。</translation>
    </message>
    <message>
        <source>%1 found home and holds close to it, but the position was not set to 0.</source>
        <translation>%1は原点を検出し、その近くで保持していますが、位置は0に設定されていません。</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>準備中</translation>
    </message>
    <message>
        <source>Backing off from the active switch</source>
        <translation>オンのスイッチから退避中</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>サーチ中</translation>
    </message>
    <message>
        <source>Searching for the index</source>
        <translation>インデックスをサーチ中</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>停止処理中</translation>
    </message>
    <message>
        <source>Verifying home</source>
        <translation>原点を確認中</translation>
    </message>
    <message>
        <source>Going to home</source>
        <translation>原点へ移動中</translation>
    </message>
    <message>
        <source>Setting position to 0</source>
        <translation>位置を0に設定中</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>移動中</translation>
    </message>
    <message>
        <source>Pausing</source>
        <translation>休止中</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>%1 did not finish its moves.</source>
        <translation>%1は移動を完了しませんでした。</translation>
    </message>
    <message>
        <source>%1 found home at %2.</source>
        <translation>%1が%2で原点を検出しました。</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1、%2 / %3</translation>
    </message>
    <message>
        <source>The switch stayed active while the motor backed off. The motor was stopped.</source>
        <translation>退避中もスイッチがオンのままでした。モーターを停止しました。</translation>
    </message>
    <message>
        <source>The motion ended before home was found. Check the search direction and the switches.</source>
        <translation>原点を検出する前に動作が終了しました。サーチ方向とスイッチを確認してください。</translation>
    </message>
    <message>
        <source>No home within the search distance. The motor was stopped.</source>
        <translation>サーチ距離内に原点がありません。モーターを停止しました。</translation>
    </message>
    <message>
        <source>No home within the time limit. The motor was stopped.</source>
        <translation>制限時間内に原点がありません。モーターを停止しました。</translation>
    </message>
    <message>
        <source>The link was unreliable. The motor was commanded to stop.</source>
        <translation>通信が不安定でした。モーターに停止を指令しました。</translation>
    </message>
    <message>
        <source>The motor switched itself off and is free to turn.</source>
        <translation>モーターは自動でオフになり、自由に回ります。</translation>
    </message>
    <message>
        <source>A command failed or was not answered. The motor was commanded to stop.</source>
        <translation>コマンドが失敗したか、応答がありませんでした。モーターに停止を指令しました。</translation>
    </message>
    <message>
        <source>Two readings of home differ. The motor is at rest.</source>
        <translation>原点の2回の読み取り値が異なります。モーターは停止しています。</translation>
    </message>
    <message>
        <source>Module %1 has no motor power, so its motor is off.</source>
        <translation>モジュール%1にモーター電源がないため、モーターはオフです。</translation>
    </message>
    <message>
        <source>Module %1 is too hot and switched its motor off.</source>
        <translation>モジュール%1が過熱のためモーターをオフにしました。</translation>
    </message>
    <message>
        <source>The A/D value fell below the thermal limit. Let the motor cool down; then check the currents and the limit on the Parameters page.</source>
        <translation>A/D値が温度制限を下回りました。モーターを冷ましてください。その後、「パラメーター」ページで電流と制限値を確認してください。</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because its E-stop input is active.</source>
        <translation>E-stop入力がオンのため、モジュール%1がモーターをオフにしました。</translation>
    </message>
    <message>
        <source>It stays off when the input is released.</source>
        <translation>入力を解除しても、オフのままです。</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off because a limit switch is active.</source>
        <translation>リミットスイッチがオンのため、モジュール%1がモーターをオフにしました。</translation>
    </message>
    <message>
        <source>Enable it again, then move in the other direction.</source>
        <translation>もう一度オンにしてから、反対方向に動かしてください。</translation>
    </message>
    <message>
        <source>Module %1 switched its motor off by itself.</source>
        <translation>モジュール%1が自動でモーターをオフにしました。</translation>
    </message>
    <message>
        <source>The cause is unknown. Check its power and inputs, then enable it again.</source>
        <translation>原因は不明です。電源と入力を確認してから、もう一度オンにしてください。</translation>
    </message>
    <message>
        <source>Amplifier off</source>
        <translation>アンプオフ</translation>
    </message>
    <message>
        <source>Stopped by a limit</source>
        <translation>リミットで停止</translation>
    </message>
    <message>
        <source>Too hot</source>
        <translation>過熱</translation>
    </message>
    <message>
        <source>Switched itself off</source>
        <translation>自動オフ</translation>
    </message>
    <message>
        <source>The module has no motor power, so its motor is off.</source>
        <translation>モジュールにモーター電源がないため、モーターはオフです。</translation>
    </message>
    <message>
        <source>The module switched its motor off when motor power failed. It stays off.</source>
        <translation>モーター電源が失われたため、モジュールがモーターをオフにしました。オフのままです。</translation>
    </message>
    <message>
        <source>The motor is free to turn. This is normal: the amplifier is switched off.</source>
        <translation>モーターは自由に回ります。これは正常です。アンプがオフです。</translation>
    </message>
    <message>
        <source>A limit switch stopped the motor. It can move in the other direction.</source>
        <translation>リミットスイッチでモーターが停止しました。反対方向には動かせます。</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input stopped the motor, or prevents it from moving.</source>
        <translation>モジュールのE-stop入力でモーターが停止したか、動けない状態です。</translation>
    </message>
    <message>
        <source>The module switched its motor off because the A/D value fell below the thermal limit. It stays off.</source>
        <translation>A/D値が温度制限を下回ったため、モジュールがモーターをオフにしました。オフのままです。</translation>
    </message>
    <message>
        <source>The module switched its motor off; the cause is unknown.</source>
        <translation>モジュールがモーターをオフにしました。原因は不明です。</translation>
    </message>
    <message>
        <source>Load a move first.</source>
        <translation>先に移動をロードしてください。</translation>
    </message>
    <message>
        <source>The position is unknown.</source>
        <translation>位置が不明です。</translation>
    </message>
    <message>
        <source>The servo is on. Switch the motor off first.</source>
        <translation>サーボがオンです。先にモーターをオフにしてください。</translation>
    </message>
    <message>
        <source>This chip version does not support it.</source>
        <translation>このバージョンのチップは対応していません。</translation>
    </message>
    <message>
        <source>Select at least one home condition.</source>
        <translation>原点の条件を1つ以上選択してください。</translation>
    </message>
    <message>
        <source>Enter a search distance and a time limit above 0.</source>
        <translation>サーチ距離と制限時間に0より大きい値を入力してください。</translation>
    </message>
    <message>
        <source>The limit switch is already active. Move the motor off it first.</source>
        <translation>リミットスイッチがすでにオンです。先にモーターをスイッチから離してください。</translation>
    </message>
    <message>
        <source>This limit pin is set as an output.</source>
        <translation>このリミットピンは出力に設定されています。</translation>
    </message>
    <message>
        <source>Enter a distance other than 0.</source>
        <translation>0以外の距離を入力してください。</translation>
    </message>
    <message>
        <source>This module is not a PIC-STEP.</source>
        <translation>このモジュールはPIC-STEPではありません。</translation>
    </message>
    <message>
        <source>Apply parameters first.</source>
        <translation>先にパラメーターを適用してください。</translation>
    </message>
    <message>
        <source>The amplifier is off. Enable it first.</source>
        <translation>アンプがオフです。先にオンにしてください。</translation>
    </message>
    <message>
        <source>Stop the motor first: the chip cannot change this in motion.</source>
        <translation>先にモーターを停止してください。動いている間は、チップがこれを変更できません。</translation>
    </message>
    <message>
        <source>The module&apos;s E-stop input is active. Release it first.</source>
        <translation>モジュールのE-stop入力がオンです。先に解除してください。</translation>
    </message>
    <message>
        <source>The A/D value is below the thermal limit: let the motor cool down, or lower the limit.</source>
        <translation>A/D値が温度制限を下回っています。モーターを冷ますか、制限値を下げてください。</translation>
    </message>
    <message>
        <source>The goal is too far away: at most 2 147 483 647 counts or steps.</source>
        <translation>目標位置が遠すぎます。最大2 147 483 647カウントまたはステップです。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open. Settings applied: %2.</source>
        <translation>「%1」を開きました。適用した設定：%2。</translation>
    </message>
    <message>
        <source>Commands sent: %1. No motor was moved.</source>
        <translation>送信したコマンド：%1。モーターは動かしていません。</translation>
    </message>
    <message>
        <source>Leader of group %1</source>
        <translation>グループ%1のリーダー</translation>
    </message>
    <message>
        <source>Cannot be applied: the file is for another module.</source>
        <translation>適用できません。ファイルは別のモジュール用です。</translation>
    </message>
    <message>
        <source>Not in the chain; its settings are kept.</source>
        <translation>チェーンにありません。設定は保持されます。</translation>
    </message>
    <message>
        <source>%1 was stopped and holds: it moved the wrong way, or by more than twice the step.</source>
        <translation>%1は再び保持しています。誤った方向に動いたか、ステップの2倍を超えて動いたためです。</translation>
    </message>
    <message>
        <source>The servo oscillates, or something else turns the motor. Lower Kp and Ki, or raise Kd, then step again.</source>
        <translation>サーボが発振しているか、ほかの力がモーターを回しています。KpとKiを下げるかKdを上げて、もう一度ステップを実行してください。</translation>
    </message>
    <message>
        <source>%1 was switched off and is free to turn: it kept oscillating after its step.</source>
        <translation>%1をオフにしました（自由に回ります）。ステップ後も発振が続いたためです。</translation>
    </message>
    <message>
        <source>The servo is not stable with these gains. Lower Kp and Ki, or raise Kd, apply them, then enable it.</source>
        <translation>このゲインではサーボが安定しません。KpとKiを下げるかKdを上げて適用してから、オンにしてください。</translation>
    </message>
    <message>
        <source>%1 does not come to rest; its servo stays on.</source>
        <translation>%1が静止しません。サーボはオンのままです。</translation>
    </message>
    <message>
        <source>It oscillates, or an external force turns it. Lower Kp and Ki, or raise Kd. Choose Motor off to end it at once.</source>
        <translation>発振しているか、外力で回されています。KpとKiを下げるか、Kdを上げてください。「モーターオフ」で直ちに終わります。</translation>
    </message>
    <message>
        <source>%1 did not complete its step: its motor switched itself off and is free to turn.</source>
        <translation>%1のステップは完了しませんでした。モーターは自動でオフになり、自由に回ります。</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, raise EL or shorten the step, then enable the motor.</source>
        <translation>位置偏差が大きすぎたか、モーター電源が失われました。引っ掛かりがないか確認し、ELを上げるかステップを小さくしてから、モーターをオンにしてください。</translation>
    </message>
    <message>
        <source>%1 does not answer, so its step was not recorded. Motor state unknown.</source>
        <translation>%1が応答しないため、ステップは記録されませんでした。モーターの状態は不明です。</translation>
    </message>
    <message>
        <source>It was commanded to hold. Use the hardware stop if it moves.</source>
        <translation>保持を指令しました。モーターが動く場合はハードウェア停止装置を使用してください。</translation>
    </message>
    <message>
        <source>%1 was commanded to hold, and its step was not recorded: the link was unreliable.</source>
        <translation>%1に保持を指令しました。ステップは記録されませんでした。通信が不安定だったためです。</translation>
    </message>
    <message>
        <source>Check the link, then step again.</source>
        <translation>通信を確認して、もう一度ステップを実行してください。</translation>
    </message>
    <message>
        <source>%1 was commanded to hold, and its step was not recorded: a command failed, or its answer was lost.</source>
        <translation>%1に保持を指令しました。ステップは記録されませんでした。コマンドが失敗したか、その応答が失われたためです。</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Step again.</source>
        <translation>多くの場合、ケーブルのノイズです。もう一度ステップを実行してください。</translation>
    </message>
    <message>
        <source>The motor does not come to rest; its servo stays on. Lower the gains, or switch the motor off.</source>
        <translation>モーターが静止しません。サーボはオンのままです。ゲインを下げるか、モーターをオフにしてください。</translation>
    </message>
    <message>
        <source>The motor kept oscillating by more than the whole step. It was switched off and is free to turn. Lower Kp and Ki, or raise Kd.</source>
        <translation>モーターがステップ全体を超える振幅で発振し続けました。モーターをオフにしました。自由に回ります。KpとKiを下げるか、Kdを上げてください。</translation>
    </message>
    <message>
        <source>its folder does not exist.</source>
        <translation>フォルダーがありません。</translation>
    </message>
    <message>
        <source>this is a folder or a device, not a file.</source>
        <translation>これはファイルではなく、フォルダーまたはデバイスです。</translation>
    </message>
    <message>
        <source>your user account has no write access.</source>
        <translation>お使いのユーザーアカウントには書き込み権限がありません。</translation>
    </message>
    <message>
        <source>the disk is read-only.</source>
        <translation>ディスクは読み取り専用です。</translation>
    </message>
    <message>
        <source>the disk is full.</source>
        <translation>ディスクに空きがありません。</translation>
    </message>
    <message>
        <source>the file is too large for the disk.</source>
        <translation>ファイルがディスクに対して大きすぎます。</translation>
    </message>
    <message>
        <source>the file was deleted.</source>
        <translation>ファイルが削除されました。</translation>
    </message>
    <message>
        <source>the disk is too slow.</source>
        <translation>ディスクが遅すぎます。</translation>
    </message>
    <message>
        <source>the disk reported a write error.</source>
        <translation>ディスクの書き込みエラーです。</translation>
    </message>
    <message>
        <source>the file ends before its column names.</source>
        <translation>列名の前でファイルが終わっています。</translation>
    </message>
    <message>
        <source>column %1 is missing.</source>
        <translation>列%1がありません。</translation>
    </message>
    <message>
        <source>the line is longer than %1 bytes, too long for a recording.</source>
        <translation>行が%1バイトを超えています。記録としては長すぎます。</translation>
    </message>
    <message>
        <source>the file ends in the middle of this line.</source>
        <translation>この行の途中でファイルが終わっています。</translation>
    </message>
    <message>
        <source>the line has %1 cells for %2 columns.</source>
        <translation>%2列に対して%1個のセルがあります。</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1が空です。</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is not a number.</source>
        <translation>%1の値「%2」は数値ではありません。</translation>
    </message>
    <message>
        <source>%1 of module %2 goes backwards.</source>
        <translation>モジュール%2の%1が逆戻りしています。</translation>
    </message>
    <message>
        <source>Recorded &quot;%1&quot;: %2.</source>
        <translation>「%1」に記録しました：%2。</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>%1に保存しました。</translation>
    </message>
    <message>
        <source>The part written before (%1) is kept.</source>
        <translation>それまでに書き込まれた部分（%1）は残ります。</translation>
    </message>
    <message>
        <source>Nothing was kept.</source>
        <translation>何も残っていません。</translation>
    </message>
    <message>
        <source>Nothing is recorded to &quot;%1&quot;: no module is connected.</source>
        <translation>「%1」には何も記録されていません。モジュールが接続されていません。</translation>
    </message>
    <message>
        <source>Connect first, then record again.</source>
        <translation>先に接続してから、もう一度記録してください。</translation>
    </message>
    <message>
        <source>Recording to &quot;%1&quot; stopped: %2</source>
        <translation>「%1」への記録が停止しました：%2</translation>
    </message>
    <message>
        <source>%1 Motor control continues. To continue recording, choose another file.</source>
        <translation>%1 制御は続いています。記録を続けるには、別のファイルを選択してください。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a recording of NMC Panel.</source>
        <translation>「%1」はNMC Panelの記録ではありません。</translation>
    </message>
    <message>
        <source>It has nothing to show. Choose another file.</source>
        <translation>表示できるものがありません。別のファイルを選択してください。</translation>
    </message>
    <message>
        <source>The scope shows the samples above that line: %1.</source>
        <translation>スコープには、その行より上のサンプルが表示されています：%1。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; contains no samples.</source>
        <translation>「%1」にはサンプルがありません。</translation>
    </message>
    <message>
        <source>Saved &quot;%1&quot;.</source>
        <translation>「%1」を保存しました。</translation>
    </message>
    <message>
        <source>Could not save &quot;%1&quot;.</source>
        <translation>「%1」を保存できませんでした。</translation>
    </message>
    <message>
        <source>Show the last 2 s</source>
        <translation>直近2秒を表示</translation>
    </message>
    <message>
        <source>Stop of all motors</source>
        <translation>全モーターの停止</translation>
    </message>
    <message>
        <source>Too far for a step response: at most 2000 counts.</source>
        <translation>ステップ応答には大きすぎます。最大2000カウントです。</translation>
    </message>
    <message>
        <source>The goal is outside the chip&apos;s position range.</source>
        <translation>目標位置がチップの位置範囲を超えています。</translation>
    </message>
    <message>
        <source>A record must be 0.02 s to 3 s long.</source>
        <translation>記録の長さは0.02～3秒でなければなりません。</translation>
    </message>
    <message>
        <source>No motor is moving. All motors are commanded to stop before the port closes.</source>
        <translation>動いているモーターはありません。ポートを閉じる前に、全モーターに停止を指令します。</translation>
    </message>
    <message>
        <source>Nothing was lost: the panel detects wrong answers and retries. If it gets worse, motors are commanded to stop. Usually noise on the cable.</source>
        <translation>失われたものはありません。パネルは誤った応答を検出し、再度問い合わせます。悪化すると、モーターに停止を指令します。多くの場合、ケーブルのノイズです。</translation>
    </message>
    <message>
        <source>It listens at 19 200 Bd and may misread the other modules&apos; traffic: all motors were commanded to stop, and sending has stopped.</source>
        <translation>このモジュールは19 200 Bdで受信しており、ほかのモジュールの通信を誤って解釈するおそれがあります。全モーターに停止を指令し、送信を中止しました。</translation>
    </message>
    <message>
        <source>The panel froze for %1; motors were commanded to stop after 2 s.</source>
        <translation>パネルが%1応答しませんでした。モーターには2秒後に停止を指令しました。</translation>
    </message>
    <message>
        <source>It was connected to %1 and was killed, or the computer failed. Motor state unknown: look at the motor before you connect; use the hardware stop if it moves. This message stays until the motor is seen at rest.</source>
        <translation>%1に接続したまま強制終了されたか、コンピューターに障害が起きました。モーターの状態は不明です。接続する前にモーターを目視で確認し、動く場合はハードウェア停止装置を使用してください。このメッセージは、モーターの停止を確認するまで表示されます。</translation>
    </message>
    <message>
        <source>I have checked: it is at rest</source>
        <translation>確認済み：停止しています</translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 do not answer</source>
        <translation>
            <numerusform>モジュール%1が応答しません</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 are off after a restart.</source>
        <translation>
            <numerusform>モジュール%1は再起動したためオフです。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop but were not seen at rest</source>
        <translation>
            <numerusform>モジュール%1に停止を指令しましたが、停止を確認できませんでした</numerusform>
        </translation>
    </message>
    <message>
        <source>You can assign just its address: the other modules keep their positions and gains.</source>
        <translation>このモジュールのアドレスだけを割り当てることができます。ほかのモジュールの位置とゲインは保たれます。</translation>
    </message>
    <message>
        <source>Assign the address of module %1</source>
        <translation>モジュール%1のアドレスを割り当て</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its motor is off, its position is 0, and it has no gains.</source>
        <translation>モジュール%1のアドレスが戻りました。モーターはオフ、位置は0で、ゲインはありません。</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its pins are inputs, and its outputs drive nothing.</source>
        <translation>モジュール%1のアドレスが戻りました。ピンは入力で、出力は何も駆動していません。</translation>
    </message>
    <message>
        <source>Module %1 has its address again. Its motor is off, its position is 0, and it has no parameters.</source>
        <translation>モジュール%1のアドレスが戻りました。モーターはオフ、位置は0で、パラメーターはありません。</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Apply its gains and home it before you use it.</source>
        <translation>ほかのモジュールは変わりません。使用する前にゲインを適用し、原点復帰を行ってください。</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Set its outputs again before you use it.</source>
        <translation>ほかのモジュールは変わりません。使用する前に出力を設定し直してください。</translation>
    </message>
    <message>
        <source>The other modules are unchanged. Apply its parameters and home it before you use it.</source>
        <translation>ほかのモジュールは変わりません。使用する前にパラメーターを適用し、原点復帰を行ってください。</translation>
    </message>
    <message>
        <source>Could not assign the address of module %1. No motor was moved.</source>
        <translation>モジュール%1のアドレスを割り当てられませんでした。モーターは動かしていません。</translation>
    </message>
    <message>
        <source>The module does not answer. Scan again, or restart the network.</source>
        <translation>モジュールが応答しません。再スキャンするか、ネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>No module is known</source>
        <translation>既知のモジュールがありません</translation>
    </message>
    <message>
        <source>: use the hardware stop.</source>
        <translation>：ハードウェア停止装置を使用してください。</translation>
    </message>
    <message>
        <source>No stop was confirmed.</source>
        <translation>停止を確認できたモーターはありません。</translation>
    </message>
    <message>
        <source>%1 of %2 stopped.</source>
        <translation>%2台中%1台が停止しました。</translation>
    </message>
    <message>
        <source>Module %1 has stopped.</source>
        <translation>モジュール%1が停止しました。</translation>
    </message>
    <message>
        <source>It has stopped.</source>
        <translation>停止しました。</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: nothing held it for over 250 ms.</source>
        <translation>モジュール%1にジョグの停止を指令しました。250 msを超えてジョグが維持されなかったためです。</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: it did not confirm the command.</source>
        <translation>モジュール%1にジョグの停止を指令しました。コマンドが確認されなかったためです。</translation>
    </message>
    <message>
        <source>Module %1 did not confirm the command to jog. Nothing was started.</source>
        <translation>モジュール%1がジョグのコマンドを確認しませんでした。何も開始していません。</translation>
    </message>
    <message>
        <source>The command or its answer was lost or garbled: if this recurs, check the cable. Press and hold again.</source>
        <translation>コマンドまたはその応答が失われたか、化けました。繰り返す場合はケーブルを確認してください。もう一度押し続けてください。</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: its state no longer permits it.</source>
        <translation>モジュール%1にジョグの停止を指令しました。現在の状態ではジョグを続けられないためです。</translation>
    </message>
    <message>
        <source>Module %1 cannot jog in its present state. Nothing was started.</source>
        <translation>モジュール%1は現在の状態ではジョグできません。何も開始していません。</translation>
    </message>
    <message>
        <source>Its state says why: for example, its motor is off. Press and hold again once it may move.</source>
        <translation>理由は状態の表示で分かります（例：モーターがオフ）。動かせる状態になったら、もう一度押し続けてください。</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop jogging: its travel limit has changed.</source>
        <translation>モジュール%1にジョグの停止を指令しました。移動範囲の限界が変わったためです。</translation>
    </message>
    <message>
        <source>Press and hold again to jog within the present limits.</source>
        <translation>現在の移動範囲内でジョグするには、もう一度押し続けてください。</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop: it reports motion, but its position stays at %2 counts.</source>
        <translation>モジュール%1に停止を指令しました。動いていると報告していますが、位置が%2カウントから変わらないためです。</translation>
    </message>
    <message>
        <source>Overcurrent: module %1 limits its motor current.</source>
        <translation>過電流：モジュール%1がモーター電流を制限しています。</translation>
    </message>
    <message>
        <source>The motor may fail to reach its goal or hold its load. Check for a jam or too heavy a load, or raise the limit. This message stays until you clear the sticky bits.</source>
        <translation>モーターが目標位置に届かない、または負荷を保持できないおそれがあります。引っ掛かりや過大な負荷がないか確認するか、制限値を上げてください。このメッセージは、スティッキービットをクリアするまで表示されます。</translation>
    </message>
    <message>
        <source>Off, but turning</source>
        <translation>オフだが回転中</translation>
    </message>
    <message>
        <source>Overcurrent</source>
        <translation>過電流</translation>
    </message>
    <message>
        <source>The shaft moves while the motor is off: a load turns it, or it is still coasting. A stop cannot hold it; use a brake, or enable the servo.</source>
        <translation>モーターがオフなのにシャフトが動いています。負荷で回されているか、まだ惰走しています。停止操作では保持できません。ブレーキを使うか、サーボをオンにしてください。</translation>
    </message>
    <message>
        <source>The motor is at rest, but its current was limited: it may not hold its load. This stays until you clear the sticky bits.</source>
        <translation>モーターは停止していますが、電流が制限されました。負荷を保持できないおそれがあります。この表示は、スティッキービットをクリアするまで残ります。</translation>
    </message>
    <message numerus="yes">
        <source>The panel ended without stopping its motors; its guardian commanded modules %1 to stop.</source>
        <translation>
            <numerusform>パネルがモーターを停止せずに終了しました。監視プログラムがモジュール%1に停止を指令しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The program was killed, or it hung. The guardian cannot see whether a motor stopped: look at the motors before you connect; use the hardware stop if one moves.</source>
        <translation>プログラムが強制終了されたか、ハングしました。監視プログラムはモーターが停止したかどうかを確認できません。接続する前にモーターを目視で確認し、動いている場合はハードウェア停止装置を使用してください。</translation>
    </message>
    <message>
        <source>The panel stalled while a motor was moving; its guardian commanded the motors to stop.</source>
        <translation>モーターが動いているときに、パネルが停滞しました。監視プログラムがモーターに停止を指令しました。</translation>
    </message>
    <message>
        <source>The program was halted, or the computer was too busy. The panel is reading all values again.</source>
        <translation>プログラムが一時停止したか、コンピューターの負荷が高すぎました。パネルはすべての値を読み直しています。</translation>
    </message>
    <message>
        <source>No guardian: if this program is killed, nothing stops the motors.</source>
        <translation>監視プログラムなし：このプログラムが強制終了されると、モーターを停止するものがありません。</translation>
    </message>
    <message>
        <source>nmcguard is missing. Reinstall the program. Everything else works.</source>
        <translation>nmcguardが見つかりません。プログラムを再インストールしてください。ほかはすべて動作します。</translation>
    </message>
    <message>
        <source>Your user account has no permission to start nmcguard. Reinstall the program. Everything else works.</source>
        <translation>お使いのユーザーアカウントではnmcguardを起動できません。プログラムを再インストールしてください。ほかはすべて動作します。</translation>
    </message>
    <message>
        <source>nmcguard and this program have different versions. Reinstall both. Everything else works.</source>
        <translation>nmcguardとこのプログラムのバージョンが異なります。両方を再インストールしてください。ほかはすべて動作します。</translation>
    </message>
    <message>
        <source>The computer ran out of memory or open files. Close other programs, then connect again. Everything else works.</source>
        <translation>コンピューターのメモリーまたは開けるファイル数が不足しました。ほかのプログラムを終了して、接続し直してください。ほかはすべて動作します。</translation>
    </message>
    <message>
        <source>The guardian ended unexpectedly. Connect again to restart it. Everything else works.</source>
        <translation>監視プログラムが予期せず終了しました。再起動するには、接続し直してください。ほかはすべて動作します。</translation>
    </message>
    <message>
        <source>These modules have no link watchdog: when the cable is cut, the adapter hangs or this computer loses power, a running motor keeps running, and no program can stop it. STOP ALL and Esc work only while the link works. A guardian stops the motors when this program is killed, crashes or hangs.</source>
        <translation>これらのモジュールには通信監視（ウォッチドッグ）がありません。ケーブルの切断、アダプターのハング、このコンピューターの電源断が起きても、運転中のモーターは動き続け、どのプログラムでも停止できません。全停止とEscが効くのは、通信できる間だけです。このプログラムの強制終了、クラッシュ、ハングのときは、監視プログラムがモーターを停止します。</translation>
    </message>
    <message>
        <source>Use --serve alone or as --serve=control.</source>
        <translation>--serveには何も付けないか、=controlを付けます。</translation>
    </message>
    <message>
        <source>--read-only requires --port or --simulator.</source>
        <translation>--read-onlyには--portまたは--simulatorが必要です。</translation>
    </message>
    <message>
        <source>Module %1 of this chain does not answer. Motor state unknown.</source>
        <translation>このチェーンのモジュール%1が応答しません。モーターの状態は不明です。</translation>
    </message>
    <message>
        <source>Check its power and the plug next to it; the panel keeps trying. If you removed it on purpose, work with the others: the panel then forgets it and its settings.</source>
        <translation>モジュールの電源と隣のプラグを確認してください。パネルは試行を続けます。意図して取り外した場合は、ほかのモジュールで作業してください。パネルはこのモジュールの登録と設定を削除します。</translation>
    </message>
    <message>
        <source>A motor is moving, so the chain was not changed.</source>
        <translation>モーターが動いているため、チェーンは変更しませんでした。</translation>
    </message>
    <message>
        <source>Forgetting a module rescans the chain. Stop all motors, then try again.</source>
        <translation>モジュールの登録を削除すると、チェーンを再スキャンします。すべてのモーターを停止してから、もう一度試してください。</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; uses module %3, so the chain was not changed.</source>
        <translation>「%2」の%1行目がモジュール%3を使用しているため、チェーンは変更しませんでした。</translation>
    </message>
    <message>
        <source>The row is for another type of module than the one found there. Change or remove it first, then try again.</source>
        <translation>この行は、そこで検出されたものとは別の種類のモジュールのためのものです。先にその行を変更または削除してから、もう一度試してください。</translation>
    </message>
    <message>
        <source>Forgetting a module removes its axis from the machine. Change or remove that row first, then try again.</source>
        <translation>モジュールの登録を削除すると、その軸もマシンから削除されます。先にその行を変更または削除してから、もう一度試してください。</translation>
    </message>
    <message>
        <source>Connected to %1 read-only: %2 at %3 Bd, left running.</source>
        <translation>%1に読み取り専用で接続しました。%2、%3 Bd、動作はそのままです。</translation>
    </message>
    <message>
        <source>The modules carry on, even after you disconnect. Only status requests are sent. STOP ALL still works.</source>
        <translation>切断しても、モジュールは動作を続けます。ステータス要求だけを送信します。全停止は使用できます。</translation>
    </message>
    <message>
        <source>A port is already open.</source>
        <translation>ポートはすでに開いています。</translation>
    </message>
    <message>
        <source>Disconnect first, then try again. Closing the port may stop motors.</source>
        <translation>先に切断してから、もう一度試してください。ポートを閉じると、モーターが停止することがあります。</translation>
    </message>
    <message numerus="yes">
        <source>Motors %1 were moving, at %2.</source>
        <translation>
            <numerusform>モーター%1が動いていました（%2）。</numerusform>
        </translation>
    </message>
    <message>
        <source>This message stays until the motor is seen at rest.</source>
        <translation>このメッセージは、モーターの停止を確認するまで表示されます。</translation>
    </message>
    <message>
        <source>Look first (read-only)</source>
        <translation>まず確認（読み取り専用）</translation>
    </message>
    <message>
        <source>This connection is read-only. Connect fully first.</source>
        <translation>読み取り専用で接続しています。先に通常接続に切り替えてください。</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, read-only</source>
        <translation>%1に接続済み、%2 Bd、%3、読み取り専用</translation>
    </message>
    <message>
        <source>Only the adapter&apos;s echo came back from %1: no module answered.</source>
        <translation>%1からはアダプターのエコーだけが返りました。応答したモジュールはありません。</translation>
    </message>
    <message>
        <source>The echo is harmless. Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the modules&apos; transmit pair is wired to the adapter.</source>
        <translation>エコー自体は問題ありません。次の順に確認してください：モジュールの電源、チェーンの全ケーブル（1本の緩みですべてのモジュールが見えなくなります）、モジュールの送信ペアがアダプターに配線されていること。</translation>
    </message>
    <message>
        <source>The adapter at %1 echoes everything it sends. The panel ignores the echo.</source>
        <translation>%1のアダプターは、送信したものをすべてエコーします。パネルはエコーを無視します。</translation>
    </message>
    <message>
        <source>This is normal for a 2-wire adapter. No action needed.</source>
        <translation>2線式アダプターでは正常です。対処は不要です。</translation>
    </message>
    <message>
        <source>no exact echo of the command before it</source>
        <translation>直前のコマンドの正確なエコーがない</translation>
    </message>
    <message>
        <source>Another host is sending on this line.</source>
        <translation>別のホストがこの回線で送信しています。</translation>
    </message>
    <message numerus="yes">
        <source>Modules %1 were commanded to stop.</source>
        <translation>
            <numerusform>モジュール%1に停止を指令しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Modules answer commands that this panel did not send; running tasks were cancelled. Close the other program, or disconnect its computer from the line, before you continue.</source>
        <translation>このパネルが送信していないコマンドにモジュールが応答しています。実行中の処理は中止しました。続ける前に、別のプログラムを終了するか、そのコンピューターを回線から外してください。</translation>
    </message>
    <message>
        <source>Module %1 moves without a command from this panel.</source>
        <translation>モジュール%1が、このパネルからのコマンドなしに動いています。</translation>
    </message>
    <message>
        <source>Another host on this line started it, or a load drives it. The panel does not stop it unless you do; the other host may start it again.</source>
        <translation>この回線の別のホストが始動したか、負荷で回されています。停止操作をしない限り、パネルは停止しません。別のホストが再び始動することもあります。</translation>
    </message>
    <message>
        <source>Home is unknown: search for it, or save it.</source>
        <translation>原点は不明です。原点サーチを行うか、保存してください。</translation>
    </message>
    <message>
        <source>Friction holds it %1 off home, too far to set the position to 0. Raise Ki and IL on the Gains page, or clear &quot;Set position to 0&quot; on the Homing page. The tolerance follows from the unit on the Axis page.</source>
        <translation>摩擦のため原点から%1ずれて止まっており、位置を0に設定するには離れすぎています。「ゲイン」ページでKiとILを上げるか、「原点復帰」ページで「位置を0に設定」を外してください。許容差は「軸」ページの単位で決まります。</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive; its motor is off.</source>
        <translation>%1の方向チェックは判定できませんでした。モーターはオフです。</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive; its motor was commanded to switch off.</source>
        <translation>%1の方向チェックは判定できませんでした。モーターオフを指令しました。</translation>
    </message>
    <message>
        <source>It turned farther than the check allows: something else turns it, or it coasts for a long time. Wait until it is at rest, then check again.</source>
        <translation>チェックの許容量を超えて回りました。ほかの力で回されているか、惰走が長くなっています。静止するまで待ってから、もう一度チェックしてください。</translation>
    </message>
    <message>
        <source>It does not come to rest although nothing drives it. Find what turns it, then check again.</source>
        <translation>駆動していないのに静止しません。回している原因を調べてから、もう一度チェックしてください。</translation>
    </message>
    <message>
        <source>The link was unreliable. Check the link, then repeat the direction check.</source>
        <translation>通信が不安定でした。通信を確認して、方向チェックをやり直してください。</translation>
    </message>
    <message>
        <source>Direction check of %1 inconclusive: it does not answer. Motor state unknown.</source>
        <translation>%1の方向チェックは判定できませんでした（応答なし）。モーターの状態は不明です。</translation>
    </message>
    <message>
        <source>It was commanded to switch off. Use the hardware stop if it moves.</source>
        <translation>モーターオフを指令しました。モーターが動く場合はハードウェア停止装置を使用してください。</translation>
    </message>
    <message>
        <source>A command failed, or its answer was lost. Repeat the direction check.</source>
        <translation>コマンドが失敗したか、その応答が失われました。方向チェックをやり直してください。</translation>
    </message>
    <message>
        <source>%1: motor and encoder directions match.</source>
        <translation>%1：モーターとエンコーダーの方向が一致しています。</translation>
    </message>
    <message>
        <source>%1: motor or encoder is reversed. Do not enable it.</source>
        <translation>%1：モーターまたはエンコーダーが逆です。オンにしないでください。</translation>
    </message>
    <message>
        <source>%1 did not move when driven.</source>
        <translation>%1は、駆動しても動きませんでした。</translation>
    </message>
    <message>
        <source>%1 closed a limit switch; the check has ended.</source>
        <translation>%1でリミットスイッチが閉じたため、それ以上は駆動しませんでした。</translation>
    </message>
    <message>
        <source>%1 lost motor power while being driven.</source>
        <translation>%1は、駆動中にモーター電源を失いました。</translation>
    </message>
    <message>
        <source>%1 did not move in both directions.</source>
        <translation>%1は両方向には動きませんでした。</translation>
    </message>
    <message>
        <source>It is at rest %1 from home; its position there is 0.</source>
        <translation>原点から%1ずれて止まっています。そこを位置0としました。</translation>
    </message>
    <message>
        <source>It rests too far from home to set the position to 0. Raise Ki and IL on the Gains page.</source>
        <translation>原点から離れすぎて止まっているため、位置を0に設定できません。「ゲイン」ページでKiとILを上げてください。</translation>
    </message>
    <message>
        <source>OK: it counts up when driven forward and down in reverse. You can enable it.</source>
        <translation>正常：正方向に駆動すると増加し、逆方向では減少します。オンにできます。</translation>
    </message>
    <message>
        <source>Reversed: it counts down when driven forward and would run away when enabled. Swap the two motor leads, or encoder A and B, then check again.</source>
        <translation>逆です。正方向に駆動すると減少するため、オンにすると暴走します。モーターの2本のリード線、またはエンコーダーのAとBを入れ替えて、もう一度チェックしてください。</translation>
    </message>
    <message>
        <source>No movement at %1 % of the supply, with motor power present. Check for a jam, a brake or too heavy a load, and check the motor and encoder cables.</source>
        <translation>モーター電源はありますが、電源の%1%でも動きません。引っ掛かり、ブレーキ、過大な負荷と、モーターとエンコーダーのケーブルを確認してください。</translation>
    </message>
    <message>
        <source>A limit switch is active: it may cut the motor&apos;s power.</source>
        <translation>リミットスイッチがオンです。モーターの電源が遮断されている可能性があります。</translation>
    </message>
    <message>
        <source>Limit switch 1 closed during the move.</source>
        <translation>移動中にリミットスイッチ1が閉じました。</translation>
    </message>
    <message>
        <source>Limit switch 2 closed during the move.</source>
        <translation>移動中にリミットスイッチ2が閉じました。</translation>
    </message>
    <message>
        <source>Turn the motor away from the end of its travel by hand, then check again.</source>
        <translation>モーターを手で回してストローク端から離し、もう一度チェックしてください。</translation>
    </message>
    <message>
        <source>Motor power failed. Switch it on, then check again.</source>
        <translation>モーター電源が失われました。電源を入れて、もう一度チェックしてください。</translation>
    </message>
    <message>
        <source>Unclear: it moved in one direction only, or twice in the same direction. Something blocks or turns it. Remove the load, turn the motor away from the end of its travel by hand, then check again.</source>
        <translation>判定不能：一方向にだけ動いたか、同じ方向に2回動きました。何かに妨げられているか、回されています。負荷を外し、モーターを手で回してストローク端から離し、もう一度チェックしてください。</translation>
    </message>
    <message>
        <source>Check for a jam, or raise EL on the Gains page.</source>
        <translation>引っ掛かりがないか確認するか、「ゲイン」ページでELを上げてください。</translation>
    </message>
    <message>
        <source>It ran away from its goal: motor or encoder is probably reversed. Run the direction check on the Axis page before you enable it again.</source>
        <translation>目標位置から離れて暴走しました。おそらくモーターまたはエンコーダーが逆です。もう一度オンにする前に、「軸」ページで方向チェックを行ってください。</translation>
    </message>
    <message>
        <source>It was driven but did not move: check for a jam, a brake or a hard stop, and check the motor cable. If it is only hard to turn, raise OL on the Gains page.</source>
        <translation>駆動しましたが、動きませんでした。引っ掛かり、ブレーキ、メカストッパーと、モーターのケーブルを確認してください。単に重いだけの場合は、「ゲイン」ページでOLを上げてください。</translation>
    </message>
    <message>
        <source>Limit switch 1 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.</source>
        <translation>リミットスイッチ1が閉じました。おそらくストローク端に達しています。反対方向に動かしてください。手前で停止させるには、「原点復帰」ページでリミット停止を有効にしてください。</translation>
    </message>
    <message>
        <source>Limit switch 2 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.</source>
        <translation>リミットスイッチ2が閉じました。おそらくストローク端に達しています。反対方向に動かしてください。手前で停止させるには、「原点復帰」ページでリミット停止を有効にしてください。</translation>
    </message>
    <message>
        <source>It moved correctly but could not keep up: lower its velocity or acceleration, or raise OL and EL on the Gains page.</source>
        <translation>正しく動きましたが、追従できませんでした。速度または加速度を下げるか、「ゲイン」ページでOLとELを上げてください。</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 closed while its motor was moving.</source>
        <translation>モーターが動いているときに、モジュール%2のリミットスイッチ%1が閉じました。</translation>
    </message>
    <message>
        <source>While the switch is closed, the module blocks this direction. Move the motor the other way.</source>
        <translation>スイッチが閉じている間、モジュールはこの方向の動作を禁止します。モーターを反対方向に動かしてください。</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 closed while its motor was moving, but does not stop it.</source>
        <translation>モーターが動いているときに、モジュール%2のリミットスイッチ%1が閉じましたが、モーターは停止しません。</translation>
    </message>
    <message>
        <source>A PIC-SERVO stops at a limit switch only while a limit stop is armed. Stop the motor, then move it the other way. Arm a limit stop on the Homing page.</source>
        <translation>PIC-SERVOがリミットスイッチで停止するのは、リミット停止が有効な間だけです。モーターを停止してから、反対方向に動かしてください。「原点復帰」ページでリミット停止を有効にしてください。</translation>
    </message>
    <message>
        <source>The limit stop of module %1 switched its motor off.</source>
        <translation>モジュール%1のリミット停止がモーターをオフにしました。</translation>
    </message>
    <message>
        <source>The limit stop of module %1 stopped its motor.</source>
        <translation>モジュール%1のリミット停止がモーターを停止しました。</translation>
    </message>
    <message>
        <source>A limit stop acts once. Move the motor off the switch, then arm or disarm the limit stop on the Homing page.</source>
        <translation>リミット停止は1回だけ作動します。モーターをスイッチから離してから、「原点復帰」ページでリミット停止を有効または無効にしてください。</translation>
    </message>
    <message>
        <source>Saving %1. The window closes when it is saved.</source>
        <translation>%1を保存しています。保存が終わるとウィンドウが閉じます。</translation>
    </message>
    <message>
        <source>Motor state unknown: %1 was moving.</source>
        <translation>モーターの状態は不明です。%1が動いていました。</translation>
    </message>
    <message>
        <source>Motor state unknown: %1 were moving.</source>
        <translation>モーターの状態は不明です。%1が動いていました。</translation>
    </message>
    <message>
        <source>Operator permissions</source>
        <translation>オペレーターに許可</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>モーターオン</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Points and sequences</source>
        <translation>ポイントとシーケンス</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>Module %1 was %2 from home when last seen.</source>
        <translation>モジュール%1は、最後の確認時に原点から%2の位置にありました。</translation>
    </message>
    <message>
        <source>That was on %1; a search had found home. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>%1の時点の値で、原点はサーチで検出したものでした。その後、軸が何によっても動かされていなければ、そこから原点を復元できます。次の原点サーチまでは未確認です。</translation>
    </message>
    <message>
        <source>That was on %1; home had been saved. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>%1の時点の値で、原点は保存されたものでした。その後、軸が何によっても動かされていなければ、そこから原点を復元できます。次の原点サーチまでは未確認です。</translation>
    </message>
    <message>
        <source>That was on %1; the position had been confirmed. If nothing has moved the axis since, you can restore home from it. It stays unverified until the next search.</source>
        <translation>%1の時点の値で、位置は確認済みでした。その後、軸が何によっても動かされていなければ、そこから原点を復元できます。次の原点サーチまでは未確認です。</translation>
    </message>
    <message>
        <source>Restore home</source>
        <translation>原点を復元</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Messages are lost when this session ends.</source>
        <translation>このセッションが終わると、メッセージは失われます。</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works. To keep messages, export the message list.</source>
        <translation>%1に書き込めません。ほかはすべて動作します。メッセージを残すには、メッセージ一覧をエクスポートしてください。</translation>
    </message>
    <message>
        <source>What led to that message is no longer kept.</source>
        <translation>そのメッセージに至った経過はもう残っていません。</translation>
    </message>
    <message>
        <source>The last %1 faults and stops can be shown. A recording keeps everything.</source>
        <translation>最近の異常と停止%1件を表示できます。記録すればすべて残ります。</translation>
    </message>
    <message>
        <source>The positions of the axes are not saved.</source>
        <translation>軸の位置は保存されません。</translation>
    </message>
    <message>
        <source>%1 is not writable. Everything else works. If the modules lose power now, search for home again: an older position may be offered.</source>
        <translation>%1に書き込めません。ほかはすべて動作します。いまモジュールの電源が切れた場合は、原点サーチをやり直してください。古い位置が提示されることがあります。</translation>
    </message>
    <message>
        <source>Limit switch %1 of module %2 stopped its motor.</source>
        <translation>モジュール%2のリミットスイッチ%1でモーターが停止しました。</translation>
    </message>
    <message>
        <source>The E-stop input of module %1 is active: its motor is on but cannot move.</source>
        <translation>モジュール%1のE-stop入力がオンです。モーターはオンですが、動けません。</translation>
    </message>
    <message>
        <source>Release the input. This does not start a motion.</source>
        <translation>入力を解除してください。解除しても動作は始まりません。</translation>
    </message>
    <message>
        <source>Not allowed in operator mode. Leave operator mode first.</source>
        <translation>オペレーターモードでは許可されていません。先にオペレーターモードを終了してください。</translation>
    </message>
    <message>
        <source>Load the move first, then choose Start: this way a garbled load never moves the motor.</source>
        <translation>先に移動をロードし、その後「開始」を選択してください。こうすれば、ロードが化けてもモーターは動きません。</translation>
    </message>
    <message>
        <source>it has no name.</source>
        <translation>名前がありません。</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is already used.</source>
        <translation>名前「%1」はすでに使われています。</translation>
    </message>
    <message>
        <source>module %1 appears twice.</source>
        <translation>モジュール%1が重複しています。</translation>
    </message>
    <message>
        <source>point &quot;%1&quot; does not exist.</source>
        <translation>ポイント「%1」がありません。</translation>
    </message>
    <message>
        <source>sequence &quot;%1&quot; does not exist.</source>
        <translation>シーケンス「%1」がありません。</translation>
    </message>
    <message>
        <source>this row makes the sequence &quot;%1&quot; call itself endlessly.</source>
        <translation>この行により、シーケンス「%1」が自分自身を無限に呼び出します。</translation>
    </message>
    <message>
        <source>a repeat must go back to an earlier row.</source>
        <translation>繰り返しの戻り先は、前の行でなければなりません。</translation>
    </message>
    <message>
        <source>Order of Home all</source>
        <translation>全軸原点復帰の順序</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>ポイント%1</translation>
    </message>
    <message>
        <source>Sequence %1</source>
        <translation>シーケンス%1</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>名前を入力してください。</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is already used. Choose another one.</source>
        <translation>名前「%1」はすでに使われています。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>Point &quot;%2&quot; contains %1 twice.</source>
        <translation>ポイント「%2」に%1が2回含まれています。</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; does not exist.</source>
        <translation>ポイント「%1」がありません。</translation>
    </message>
    <message>
        <source>Sequence &quot;%1&quot; does not exist.</source>
        <translation>シーケンス「%1」がありません。</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; would call itself endlessly.</source>
        <translation>シーケンス「%1」が自分自身を無限に呼び出します。</translation>
    </message>
    <message>
        <source>A repeat must go back to an earlier row.</source>
        <translation>繰り返しの戻り先は、前の行でなければなりません。</translation>
    </message>
    <message>
        <source>The sequence has no rows. Add a row first.</source>
        <translation>シーケンスに行がありません。先に行を追加してください。</translation>
    </message>
    <message>
        <source>Point &quot;%1&quot; has no axes. Teach it again.</source>
        <translation>ポイント「%1」に軸がありません。教示し直してください。</translation>
    </message>
    <message>
        <source>%1 is not in the chain.</source>
        <translation>%1はチェーンにありません。</translation>
    </message>
    <message>
        <source>Point &quot;%2&quot; was taught before home of %1 was known, so it may have shifted. Teach it again.</source>
        <translation>ポイント「%2」は%1の原点が判明する前に教示されたため、ずれている可能性があります。教示し直してください。</translation>
    </message>
    <message>
        <source>Homing of %1 is not set up. Set it up on its Homing page.</source>
        <translation>%1の原点復帰が設定されていません。「原点復帰」ページで設定してください。</translation>
    </message>
    <message>
        <source>%1 does not have this input or output.</source>
        <translation>%1にはこの入力または出力がありません。</translation>
    </message>
    <message>
        <source>The outputs of %1 are unknown. Set them once on the module&apos;s page.</source>
        <translation>%1の出力が不明です。モジュールのページで一度設定してください。</translation>
    </message>
    <message>
        <source>A run from the top never gets here: an earlier row repeats forever.</source>
        <translation>先頭から運転すると、ここには到達しません。前の行が無限に繰り返されます。</translation>
    </message>
    <message>
        <source>At this row, %1 must be at home. Move it there first.</source>
        <translation>この行では、%1が原点になければなりません。先に移動してください。</translation>
    </message>
    <message>
        <source>At this row, %1 must be at point &quot;%2&quot;. Move it there first.</source>
        <translation>この行では、%1がポイント「%2」になければなりません。先に移動してください。</translation>
    </message>
    <message>
        <source>At this row, output %1 of %2 must be in the opposite state. Set it first.</source>
        <translation>この行では、%2の出力%1が切り替わっていなければなりません。先に設定してください。</translation>
    </message>
    <message>
        <source>You stopped it.</source>
        <translation>操作により停止しました。</translation>
    </message>
    <message>
        <source>All motors were stopped.</source>
        <translation>すべてのモーターを停止しました。</translation>
    </message>
    <message>
        <source>%1 received another command, or something else moved it.</source>
        <translation>%1が別のコマンドを受けたか、ほかの力で動かされました。</translation>
    </message>
    <message>
        <source>A limit switch of %1 closed during the move.</source>
        <translation>移動中に%1のリミットスイッチが閉じました。</translation>
    </message>
    <message>
        <source>%1 stopped before it reached its goal.</source>
        <translation>%1は目標位置に達する前に停止しました。</translation>
    </message>
    <message>
        <source>The motor of %1 switched off.</source>
        <translation>%1のモーターがオフになりました。</translation>
    </message>
    <message>
        <source>%1 of %2 did not become high within %3 s.</source>
        <translation>%2の%1が%3秒以内にHighになりませんでした。</translation>
    </message>
    <message>
        <source>%1 of %2 did not become low within %3 s.</source>
        <translation>%2の%1が%3秒以内にLowになりませんでした。</translation>
    </message>
    <message>
        <source>%1 of %2 did not become active within %3 s.</source>
        <translation>%2の%1が%3秒以内にアクティブになりませんでした。</translation>
    </message>
    <message>
        <source>%1 of %2 did not become inactive within %3 s.</source>
        <translation>%2の%1が%3秒以内に非アクティブになりませんでした。</translation>
    </message>
    <message>
        <source>%1 did not find home.</source>
        <translation>%1は原点を検出できませんでした。</translation>
    </message>
    <message>
        <source>The link was unreliable.</source>
        <translation>通信が不安定でした。</translation>
    </message>
    <message>
        <source>%1 does not answer.</source>
        <translation>%1が応答しません。</translation>
    </message>
    <message>
        <source>%1 refused or did not answer a command.</source>
        <translation>%1がコマンドを拒否したか、応答しませんでした。</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1、%2行目</translation>
    </message>
    <message>
        <source>%1, pass %2</source>
        <translation>%1、%2周目</translation>
    </message>
    <message>
        <source>Move to &quot;%1&quot;</source>
        <translation>「%1」へ移動</translation>
    </message>
    <message>
        <source>Sequence &quot;%1&quot;</source>
        <translation>シーケンス「%1」</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4 in all, moves: %5</source>
        <translation>%1：%2～%3、合計%4、移動回数：%5</translation>
    </message>
    <message>
        <source>move to</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>wait</source>
        <translation>待機</translation>
    </message>
    <message>
        <source>wait for arrival</source>
        <translation>到着を待つ</translation>
    </message>
    <message>
        <source>wait for input</source>
        <translation>入力を待つ</translation>
    </message>
    <message>
        <source>set output</source>
        <translation>出力を設定</translation>
    </message>
    <message>
        <source>find home</source>
        <translation>原点復帰</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>繰り返し</translation>
    </message>
    <message>
        <source>call</source>
        <translation>呼び出し</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>原点スイッチ</translation>
    </message>
    <message>
        <source>%1: %2 from home</source>
        <translation>%1：原点から%2</translation>
    </message>
    <message>
        <source>%1: at %2, home unknown</source>
        <translation>%1：%2、原点不明</translation>
    </message>
    <message>
        <source>%1, row %2: %3</source>
        <translation>%1、%2行目：%3</translation>
    </message>
    <message>
        <source>Running: %1</source>
        <translation>運転中：%1</translation>
    </message>
    <message>
        <source>Finishing its row, then pausing: %1</source>
        <translation>行を終えてから一時停止：%1</translation>
    </message>
    <message>
        <source>Paused before: %1</source>
        <translation>一時停止中、次は%1</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>停止処理中：%1</translation>
    </message>
    <message>
        <source>Ended: %1. %2</source>
        <translation>終了：%1。%2</translation>
    </message>
    <message>
        <source>%1 is done.</source>
        <translation>%1が完了しました。</translation>
    </message>
    <message>
        <source>%1 ended, and its motors were commanded to stop.</source>
        <translation>%1を終了し、モーターに停止を指令しました。</translation>
    </message>
    <message>
        <source>It was at: %1. To continue, select a row and choose Run from row. Nothing restarts on its own.</source>
        <translation>中断箇所：%1。続けるには、行を選択して「行から運転」を選択してください。自動では再開しません。</translation>
    </message>
    <message>
        <source>Nothing was started.</source>
        <translation>何も開始していません。</translation>
    </message>
    <message>
        <source>Dry run: the sequence would not start.</source>
        <translation>模擬実行：シーケンスは開始できません。</translation>
    </message>
    <message>
        <source>Dry run: the simulation was not ready. Try again.</source>
        <translation>模擬実行：シミュレーションの準備ができていません。もう一度試してください。</translation>
    </message>
    <message>
        <source>Dry run: %1 cannot be simulated. %2</source>
        <translation>模擬実行：%1をシミュレートできません。%2</translation>
    </message>
    <message>
        <source>Dry run: cut off after %1 s.</source>
        <translation>模擬実行：%1秒で打ち切りました。</translation>
    </message>
    <message>
        <source>Dry run: done after %1 s.</source>
        <translation>模擬実行：%1秒で完了しました。</translation>
    </message>
    <message>
        <source>Dry run: it would end after %1 s. %2</source>
        <translation>模擬実行：%1秒で終了します。%2</translation>
    </message>
    <message>
        <source>Homing takes longer in reality: %1.</source>
        <translation>原点復帰は、実際にはもっと時間がかかります：%1。</translation>
    </message>
    <message>
        <source>Inputs were assumed to change at once.</source>
        <translation>入力はすぐに変化するものと仮定しました。</translation>
    </message>
    <message>
        <source>An endless repeat ran once.</source>
        <translation>無限の繰り返しは1回だけ実行しました。</translation>
    </message>
    <message>
        <source>Simulated motors were used; real motors may take longer.</source>
        <translation>シミュレーションのモーターを使用しました。実際のモーターでは、もっと時間がかかることがあります。</translation>
    </message>
    <message>
        <source>the lowest position is not below the highest.</source>
        <translation>最小位置が最大位置より小さくありません。</translation>
    </message>
    <message>
        <source>Lowest position, from home</source>
        <translation>最小位置（原点から）</translation>
    </message>
    <message>
        <source>Highest position, from home</source>
        <translation>最大位置（原点から）</translation>
    </message>
    <message>
        <source>Highest velocity</source>
        <translation>最高速度</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>行き過ぎ量</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>Armed for each motion</source>
        <translation>動作ごとに有効</translation>
    </message>
    <message>
        <source>%1 was stopped: home not found within its travel limits or at its last known position.</source>
        <translation>%1を停止しました。移動範囲内にも前回の場所にも原点が見つからなかったためです。</translation>
    </message>
    <message>
        <source>Check the switch and its cable, and the search direction. If the position is wrong, choose Position in doubt on the Axis page: the next search then uses only its search distance.</source>
        <translation>スイッチとケーブル、サーチ方向を確認してください。位置が間違っている場合は、「軸」ページで「位置に疑いあり」を選択してください。次のサーチでは、サーチ距離だけが適用されます。</translation>
    </message>
    <message>
        <source>Taking up backlash</source>
        <translation>バックラッシ除去中</translation>
    </message>
    <message>
        <source>The move would exceed the travel limits. The motor was stopped.</source>
        <translation>移動が移動範囲を超えます。モーターを停止しました。</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop just before its travel limit.</source>
        <translation>モジュール%1に、移動範囲の限界の直前で停止を指令しました。</translation>
    </message>
    <message>
        <source>The chip does not end this kind of motion by itself, so the panel did. Check the position before you continue.</source>
        <translation>この種の動作はチップが自動では終了しないため、パネルが停止しました。続ける前に位置を確認してください。</translation>
    </message>
    <message>
        <source>That is beyond this axis&apos;s travel limits (Axis page).</source>
        <translation>この軸の移動範囲（「軸」ページ）を超えています。</translation>
    </message>
    <message>
        <source>Travel limit reached. Move in the other direction.</source>
        <translation>移動範囲の限界に達しました。反対方向に動かしてください。</translation>
    </message>
    <message>
        <source>That exceeds this axis&apos;s highest velocity (Axis page).</source>
        <translation>この軸の最高速度（「軸」ページ）を超えています。</translation>
    </message>
    <message>
        <source>Stop first: a run towards a travel limit must start from standstill, so that the chip can end it there.</source>
        <translation>先に停止してください。移動範囲の限界に向かう運転は、チップがそこで終了できるように、停止状態から始めます。</translation>
    </message>
    <message>
        <source>Wait until the limit stop of this axis is armed.</source>
        <translation>この軸のリミット停止が有効になるまで待ってください。</translation>
    </message>
    <message>
        <source>The current limit CL is 0 or unknown, so current cannot stop the motor. Apply a CL first.</source>
        <translation>電流制限CLが0または不明のため、電流ではモーターを停止できません。先にCLを適用してください。</translation>
    </message>
    <message>
        <source>A limit switch, overheating or the E-stop input ended the move. The motor is at rest.</source>
        <translation>リミットスイッチ、過熱、またはE-stop入力で移動が終了しました。モーターは停止しています。</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed setting their position to 0.</source>
        <translation>グループ%1に、位置を0にしたことを確認応答していないモジュールがあります。</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed clearing their sticky bits. A persistent fault sets its bit again at once.</source>
        <translation>グループ%1に、スティッキービットのクリアを確認応答していないモジュールがあります。続いている異常は、すぐにビットを再びセットします。</translation>
    </message>
    <message>
        <source>Not all modules of group %1 confirmed the command.</source>
        <translation>グループ%1に、コマンドを確認応答していないモジュールがあります。</translation>
    </message>
    <message>
        <source>A group command requires that every member answers and can carry it out in its present state, and that the group of every module is known. Command the modules one by one, or set this module&apos;s group again.</source>
        <translation>グループコマンドには、全メンバーが応答すること、各メンバーが実行できる状態であること、全モジュールのグループが分かっていることが必要です。モジュールに1台ずつ指令するか、このモジュールのグループを設定し直してください。</translation>
    </message>
    <message>
        <source>Group %1 was commanded to switch its motors off: module %2.</source>
        <translation>グループ%1にモーターオフを指令しました：モジュール%2。</translation>
    </message>
    <message>
        <source>Group %1 was commanded to stop: module %2.</source>
        <translation>グループ%1に停止を指令しました：モジュール%2。</translation>
    </message>
    <message>
        <source>This computer&apos;s port does not support %1 Bd. Choose another baud rate.</source>
        <translation>このコンピューターのポートは%1 Bdに対応していません。別のボーレートを選択してください。</translation>
    </message>
    <message>
        <source>Module %1 now has address %2. Position, gains and group are unchanged.</source>
        <translation>モジュール%1のアドレスは%2になりました。位置、ゲイン、グループは変わりません。</translation>
    </message>
    <message>
        <source>The address is used by another module or not allowed. Choose a free address from 1 to 127.</source>
        <translation>アドレスが別のモジュールで使われているか、使用できません。1～127の空いているアドレスを選んでください。</translation>
    </message>
    <message>
        <source>Its group is unknown and would change with the address. Set its group first, or none.</source>
        <translation>グループが不明で、アドレスとともに変わってしまいます。先にグループを設定するか、「なし」にしてください。</translation>
    </message>
    <message>
        <source>Another module without an address would take it. Assign that module&apos;s address first, or restart the network.</source>
        <translation>アドレスのない別のモジュールがこのアドレスを受け取ってしまいます。先にそのモジュールのアドレスを割り当てるか、ネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>The exact position that the servo holds is unknown. Choose Hold here first, or move the motor.</source>
        <translation>サーボが保持している正確な位置が不明です。「先にここで保持」を選択するか、モーターを動かしてください。</translation>
    </message>
    <message>
        <source>Module %1 oscillates while it holds its position.</source>
        <translation>モジュール%1はモーターを保持していますが、発振しています。</translation>
    </message>
    <message>
        <source>Its servo is not stable with these gains. Lower Kp and Ki, or raise Kd, and apply them.</source>
        <translation>このゲインではサーボが安定しません。KpとKiを下げるかKdを上げて、適用してください。</translation>
    </message>
    <message>
        <source>Restore previous gains</source>
        <translation>以前のゲインを復元</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: it began to oscillate.</source>
        <translation>%1のゲインを元に戻しました。発振し始めたためです。</translation>
    </message>
    <message>
        <source>Lower Kp and Ki, or raise Kd, then try again.</source>
        <translation>KpとKiを下げるかKdを上げて、もう一度試してください。</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: it left its position.</source>
        <translation>%1のゲインを元に戻しました。位置から離れたためです。</translation>
    </message>
    <message>
        <source>These gains do not hold its load, or something else turned it.</source>
        <translation>このゲインでは負荷を保持できないか、ほかの力で回されました。</translation>
    </message>
    <message>
        <source>%1 switched itself off while gains were being tried, and is free to turn.</source>
        <translation>%1はゲインの試用中に自動でオフになり、自由に回ります。</translation>
    </message>
    <message>
        <source>Its previous gains were sent again. Check for a jam, then enable it.</source>
        <translation>以前のゲインを再送しました。引っ掛かりがないか確認してから、オンにしてください。</translation>
    </message>
    <message>
        <source>%1 does not answer while gains are being tried. Motor state unknown.</source>
        <translation>%1がゲインの試用中に応答しません。モーターの状態は不明です。</translation>
    </message>
    <message>
        <source>Its previous gains were sent. Use the hardware stop if it moves.</source>
        <translation>以前のゲインを送信しました。モーターが動く場合はハードウェア停止装置を使用してください。</translation>
    </message>
    <message>
        <source>The new gains of %1 are in force; OL may still be lowered.</source>
        <translation>%1の新しいゲインが有効です。OLはまだ下げられたままの可能性があります。</translation>
    </message>
    <message>
        <source>A command failed, or its answer was lost. Apply the gains again.</source>
        <translation>コマンドが失敗したか、応答が失われました。もう一度ゲインを適用してください。</translation>
    </message>
    <message>
        <source>The previous gains of %1 were sent again: the link was unreliable.</source>
        <translation>%1の以前のゲインを再送しました。通信が不安定だったためです。</translation>
    </message>
    <message>
        <source>Check the link, then try again.</source>
        <translation>通信を確認して、もう一度試してください。</translation>
    </message>
    <message>
        <source>The previous gains of %1 were sent again: a command failed, or its answer was lost.</source>
        <translation>%1の以前のゲインを再送しました。コマンドが失敗したか、その応答が失われたためです。</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Try again.</source>
        <translation>多くの場合、ケーブルのノイズです。もう一度試してください。</translation>
    </message>
    <message>
        <source>Trying gains</source>
        <translation>ゲイン試用中</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: the trial has ended.</source>
        <translation>%1のゲインを元に戻しました。試用が終わったためです。</translation>
    </message>
    <message>
        <source>The motor began to oscillate. The previous gains are restored.</source>
        <translation>モーターが発振し始めました。以前のゲインに戻しました。</translation>
    </message>
    <message>
        <source>Could not print the page.</source>
        <translation>ページを印刷できませんでした。</translation>
    </message>
    <message>
        <source>%1 Export the page as a PDF file and print that file.</source>
        <translation>%1 ページをPDFファイルにエクスポートし、そのファイルを印刷してください。</translation>
    </message>
    <message>
        <source>The page was sent to the printer.</source>
        <translation>ページをプリンターに送りました。</translation>
    </message>
    <message>
        <source>The program %1, which sends pages to the printer, is not installed.</source>
        <translation>ページをプリンターに送るプログラム%1がインストールされていません。</translation>
    </message>
    <message>
        <source>The print system refused it: see Details.</source>
        <translation>印刷システムが拒否しました。「詳細」を参照してください。</translation>
    </message>
    <message>
        <source>Could not read the step responses of this machine.</source>
        <translation>このマシンのステップ応答を読み込めませんでした。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file of step responses.</source>
        <translation>「%1」はステップ応答のファイルではありません。</translation>
    </message>
    <message>
        <source>The file is kept: before new step responses are saved, it is moved to %1.</source>
        <translation>ファイルは保持されます。新しいステップ応答を保存する前に、%1に移されます。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not readable. It is moved aside before new step responses are saved.</source>
        <translation>「%1」を読み取れません。新しいステップ応答を保存する前に、別の場所に移されます。</translation>
    </message>
    <message>
        <source>The step responses of this session are not saved.</source>
        <translation>このセッションのステップ応答は保存されません。</translation>
    </message>
    <message>
        <source>%1 is not writable. Export them before you close the panel.</source>
        <translation>%1に書き込めません。パネルを閉じる前にエクスポートしてください。</translation>
    </message>
    <message>
        <source>The loop test of %1 ended early.</source>
        <translation>%1：ループテストが途中で終了しました。</translation>
    </message>
    <message>
        <source>The motor moved farther than the test allows, and was commanded to hold. Check for a load that pulls it, or use lower gains.</source>
        <translation>モーターがテストの許容量を超えて動いたため、保持を指令しました。引っ張る負荷がないか確認するか、ゲインを下げてください。</translation>
    </message>
    <message>
        <source>A value of this test is out of range.</source>
        <translation>このテストの値が範囲外です。</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>The module answers. It has inputs and outputs, but no motor.</source>
        <translation>モジュールは応答しています。入出力だけで、モーターはありません。</translation>
    </message>
    <message>
        <source>This module drives no motor.</source>
        <translation>このモジュールはモーターを駆動しません。</translation>
    </message>
    <message>
        <source>This module is not a PIC-I/O.</source>
        <translation>このモジュールはPIC-I/Oではありません。</translation>
    </message>
    <message>
        <source>A module ended the path by itself: a limit switch, a position error, or no motor power. All axes of the path were commanded to stop.</source>
        <translation>モジュールがパスを自動で終了しました：リミットスイッチ、位置偏差、またはモーター電源なし。パスの全軸に停止を指令しました。</translation>
    </message>
    <message>
        <source>%1 has not finished its path.</source>
        <translation>%1はパスを完了していません。</translation>
    </message>
    <message>
        <source>Not all axes started the path. All of them were commanded to stop.</source>
        <translation>パスの一部の軸が開始しませんでした。全軸に停止を指令しました。</translation>
    </message>
    <message>
        <source>The path points did not arrive in time, so the motor stopped at the last one.</source>
        <translation>パスの点が間に合わなかったため、モーターは最後に受け取った点で停止しました。</translation>
    </message>
    <message>
        <source>The command position left the path. The motor was commanded to stop.</source>
        <translation>指令位置がパスから外れました。停止を指令しました。</translation>
    </message>
    <message>
        <source>On a path</source>
        <translation>パス追従中</translation>
    </message>
    <message>
        <source>The path cannot be followed from here.</source>
        <translation>ここからはパスに追従できません。</translation>
    </message>
    <message>
        <source>Enable it, then move it the other way. The Amplifier page sets what a closed limit does.</source>
        <translation>オンにしてから、反対方向に動かしてください。リミットが閉じたときの動作は「アンプ」ページで設定します。</translation>
    </message>
    <message>
        <source>Limit switch %1 closed, and module %2 switched its motor off.</source>
        <translation>リミットスイッチ%1が閉じ、モジュール%2がモーターをオフにしました。</translation>
    </message>
    <message>
        <source>The limit in that direction is closed. Move the motor the other way.</source>
        <translation>その方向のリミットが閉じています。モーターを反対方向に動かしてください。</translation>
    </message>
    <message>
        <source>The rate &quot;%1&quot; does not exist. Use 30, 60 or 120.</source>
        <translation>レート「%1」はありません。30、60、120のいずれかを使用してください。</translation>
    </message>
    <message>
        <source>The file has no line that names its axes.</source>
        <translation>ファイルに、軸の名前を示す行がありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an axis that can follow a path.</source>
        <translation>「%1」は、パスに追従できる軸ではありません。</translation>
    </message>
    <message>
        <source>This axis is named twice.</source>
        <translation>この軸が重複しています。</translation>
    </message>
    <message>
        <source>A position is missing.</source>
        <translation>位置が不足しています。</translation>
    </message>
    <message>
        <source>The line has %1 positions; the file has %2 axes.</source>
        <translation>この行の位置は%1個ですが、ファイルの軸は%2個です。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>「%1」は数値ではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is outside the module&apos;s position range.</source>
        <translation>「%1」は、モジュールが数えられる範囲を超えています。</translation>
    </message>
    <message>
        <source>The point is %1 from the previous one; at this rate the maximum is %2.</source>
        <translation>点が前の点から%1離れています。このレートでは最大%2までです。</translation>
    </message>
    <message>
        <source>This needs a velocity of %1; the limit of the axis is %2.</source>
        <translation>%1の速度が必要ですが、この軸は%2に制限されています。</translation>
    </message>
    <message>
        <source>%1 is beyond the travel limit of %2.</source>
        <translation>%1は移動範囲の限界%2を超えています。</translation>
    </message>
    <message>
        <source>A path needs at least two points.</source>
        <translation>パスには2つ以上の点が必要です。</translation>
    </message>
    <message>
        <source>A path has at most %1 points.</source>
        <translation>パスの点数は最大%1です。</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>%1行目：%2</translation>
    </message>
    <message>
        <source>Line %1, %2: %3</source>
        <translation>%1行目、%2：%3</translation>
    </message>
    <message>
        <source>%1 has no path buffer. Only a PIC-SERVO CMC or SC can follow a path.</source>
        <translation>%1にはパスバッファーがありません。パスに追従するのは、PIC-SERVO CMCとSCだけです。</translation>
    </message>
    <message>
        <source>The I/O settings of %1 are unknown: another program set them. Apply them first on the Amplifier or Limits and I/O page.</source>
        <translation>%1のI/O設定は不明です。別のプログラムが設定したものです。先に「アンプ」ページまたは「リミットとI/O」ページで適用してください。</translation>
    </message>
    <message>
        <source>%1 is set to step and direction input. Switch that off on its Amplifier page first.</source>
        <translation>%1はステップ/方向パルスに従います。先に「アンプ」ページでオフにしてください。</translation>
    </message>
    <message>
        <source>%1: a path at 30 Hz needs fast path off (Amplifier or Limits and I/O page).</source>
        <translation>%1：30 Hzのパスでは、「高速パス」をオフにする必要があります（「アンプ」ページまたは「リミットとI/O」ページ）。</translation>
    </message>
    <message>
        <source>%1: a path at 120 Hz needs fast path on (Amplifier or Limits and I/O page).</source>
        <translation>%1：120 Hzのパスでは、「高速パス」をオンにする必要があります（「アンプ」ページまたは「リミットとI/O」ページ）。</translation>
    </message>
    <message>
        <source>%1: a path needs a servo rate divisor of 1. Apply the gains with SR = 1 first.</source>
        <translation>%1：パスにはサーボレートSR = 1が必要です。先にSRを1にしてゲインを適用してください。</translation>
    </message>
    <message>
        <source>%1 has not reported its command position yet.</source>
        <translation>%1はまだ指令位置を報告していません。</translation>
    </message>
    <message>
        <source>%1 is %2 from the first point. Choose Move to start first.</source>
        <translation>%1は最初の点から%2離れています。先に「始点へ移動」を選択してください。</translation>
    </message>
    <message>
        <source>%1: point %2 is %3 from the previous one; at this rate the maximum is %4.</source>
        <translation>%1：点%2が前の点から%3離れています。このレートでは最大%4までです。</translation>
    </message>
    <message>
        <source>%1: point %2 needs a velocity of %3; the limit of the axis is %4.</source>
        <translation>%1：点%2には%3の速度が必要ですが、この軸は%4に制限されています。</translation>
    </message>
    <message>
        <source>%1: point %2 at %3 is beyond the travel limit of %4.</source>
        <translation>%1：点%2（%3）は移動範囲の限界%4を超えています。</translation>
    </message>
    <message>
        <source>The path does not fit this chain. Open it again.</source>
        <translation>パスがこのチェーンに合いません。もう一度開いてください。</translation>
    </message>
    <message>
        <source>The axes of a path start together. Put them, and no other module, into one group: Chain, Groups.</source>
        <translation>パスの軸は同時に開始します。それらの軸だけを1つのグループにまとめ、ほかのモジュールは入れないでください：「チェーン」の「グループ」。</translation>
    </message>
    <message>
        <source>The path needs %1 % of the bus time; %2 % is available. Use a higher baud rate or a lower path rate.</source>
        <translation>パスはバスの時間の%1%を必要としますが、使用できるのは%2%です。ボーレートを上げるか、パスのレートを下げてください。</translation>
    </message>
    <message>
        <source>%1 cannot follow a path. Only a PIC-SERVO CMC or SC can.</source>
        <translation>%1はパスに追従できません。追従できるのは、PIC-SERVO CMCとSCだけです。</translation>
    </message>
    <message>
        <source>%1 does not hold a known position. Enable its servo, and find home if the points count from home.</source>
        <translation>%1は既知の位置で保持していません。サーボをオンにし、点を原点から数える場合は原点復帰も行ってください。</translation>
    </message>
    <message>
        <source>Only moves, waits, repeats and calls can become a path.</source>
        <translation>パスにできるのは、移動、待機、繰り返し、呼び出しだけです。</translation>
    </message>
    <message>
        <source>A path cannot repeat forever.</source>
        <translation>パスを無限に繰り返すことはできません。</translation>
    </message>
    <message>
        <source>Up to here the path would have more than %1 points.</source>
        <translation>ここまでで、パスの点数が%1を超えます。</translation>
    </message>
    <message>
        <source>The sequence &quot;%1&quot; moves nothing.</source>
        <translation>シーケンス「%1」は何も動かしません。</translation>
    </message>
    <message>
        <source>Could not open &quot;%1&quot;. %2</source>
        <translation>「%1」を開けませんでした。%2</translation>
    </message>
    <message>
        <source>The path is done. Each axis holds its last point.</source>
        <translation>パスを完了しました。各軸は最後の点で保持しています。</translation>
    </message>
    <message>
        <source>The path was stopped.</source>
        <translation>パスを停止しました。</translation>
    </message>
    <message>
        <source>Starting the path</source>
        <translation>パスを開始中</translation>
    </message>
    <message>
        <source>Point %1 of %2, %3 s left, %4 points left in the buffer</source>
        <translation>点%1 / %2、残り%3 s、バッファー内の先行点数%4</translation>
    </message>
    <message>
        <source>%1. The buffer is about to run dry: the bus is too slow.</source>
        <translation>%1。まもなくバッファーが空になります：バスが遅すぎます。</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1：%2～%3</translation>
    </message>
    <message>
        <source>%1 points at %2 Hz, %3 s</source>
        <translation>%1点、%2 Hz、%3 s</translation>
    </message>
    <message>
        <source>SM, step multiplier</source>
        <translation>SM、ステップ倍率</translation>
    </message>
    <message>
        <source>Fast path</source>
        <translation>高速パス</translation>
    </message>
    <message>
        <source>This pin of %1 is set as an output.</source>
        <translation>%1のこのピンは出力に設定されています。</translation>
    </message>
    <message>
        <source>This pin of %1 is not set as an output. Make it an output first.</source>
        <translation>%1のこのピンは出力に設定されていません。「I/O」ページで設定してください。</translation>
    </message>
    <message>
        <source>A/D %1 of %2 did not rise above %3 of 255 within %4 s.</source>
        <translation>%2のA/D %1が%4秒以内に255中%3を上回りませんでした。</translation>
    </message>
    <message>
        <source>A/D %1 of %2 did not fall below %3 of 255 within %4 s.</source>
        <translation>%2のA/D %1が%4秒以内に255中%3を下回りませんでした。</translation>
    </message>
    <message>
        <source>wait for A/D</source>
        <translation>A/Dを待つ</translation>
    </message>
    <message numerus="yes">
        <source>No stop command is known for modules %1</source>
        <translation>
            <numerusform>モジュール%1には停止を指令できません</numerusform>
        </translation>
    </message>
    <message>
        <source>If it moved the wrong way, run the direction check on the Axis page.</source>
        <translation>逆方向に動いた場合は、「軸」ページで方向チェックを行ってください。</translation>
    </message>
    <message>
        <source>The position error was too large, or motor power failed. Check for a jam, raise EL or make the test smaller, then enable the motor.</source>
        <translation>位置偏差が大きすぎたか、モーター電源が失われました。引っ掛かりがないか確認し、ELを上げるかテストを小さくしてから、モーターをオンにしてください。</translation>
    </message>
    <message>
        <source>Check the link, then start the test again.</source>
        <translation>通信を確認して、もう一度テストを開始してください。</translation>
    </message>
    <message>
        <source>Usually noise on the cable. Start the test again.</source>
        <translation>多くの場合、ケーブルのノイズです。もう一度テストを開始してください。</translation>
    </message>
    <message>
        <source>%1 did not complete its step: its limit stop ended it.</source>
        <translation>%1のステップは完了しませんでした。リミット停止が作動しました。</translation>
    </message>
    <message>
        <source>Its limit stop ended the test.</source>
        <translation>リミット停止がテストを終了しました。</translation>
    </message>
    <message>
        <source>The motor did not follow the sine wave, and was commanded to hold. Check for a jam, a hard stop, a slipping coupling or missing motor power, or use another amplitude.</source>
        <translation>モーターが正弦波に追従しなかったため、保持を指令しました。引っ掛かり、メカストッパー、カップリングの滑り、モーター電源を確認するか、別の振幅を使用してください。</translation>
    </message>
    <message>
        <source>The previous gains of %1 are restored: its output reached the limit OL.</source>
        <translation>%1は以前のゲインに戻りました。出力が制限値OLに達しました。</translation>
    </message>
    <message>
        <source>It oscillates, or was pushed. Lower Kp, or raise Kd, then try again.</source>
        <translation>振動したか、外力を受けました。Kpを下げるかKdを上げてから、もう一度試してください。</translation>
    </message>
    <message>
        <source>Looking for printers…</source>
        <translation>プリンターを探しています…</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Add one in the system&apos;s printer settings, or save the page as a PDF file.</source>
        <translation>このコンピューターにはプリンターが設定されていません。システムのプリンター設定で追加するか、ページをPDFファイルとして保存してください。</translation>
    </message>
    <message>
        <source>Printer: %1</source>
        <translation>プリンター: %1</translation>
    </message>
    <message>
        <source>The output reached its limit. The previous gains are restored.</source>
        <translation>出力が制限値に達しました。以前のゲインに戻しました。</translation>
    </message>
    <message>
        <source>The line at %1 was disturbed while the modules were given addresses.</source>
        <translation>モジュールにアドレスを割り当てている間に、%1の回線が乱れました。</translation>
    </message>
    <message>
        <source>A module that had answered stopped answering, so the number of modules is unknown. No motor was moved. Check the cable and the adapter, then scan again.</source>
        <translation>応答していたモジュールが応答しなくなったため、台数は不明です。モーターは動かしていません。ケーブルとアダプターを確認してから、再スキャンしてください。</translation>
    </message>
    <message>
        <source>The adapter at %1 passes answers on in pieces, up to %2 ms apart.</source>
        <translation>%1のアダプターは、応答を最大%2 msの間隔で分割して渡します。</translation>
    </message>
    <message>
        <source>USB hubs, Bluetooth and device servers do that. The panel waits for the rest, so updates are slower. No action needed.</source>
        <translation>USBハブ、Bluetooth、デバイスサーバーではよくあることです。パネルは残りを待つため、更新が遅くなります。対処は不要です。</translation>
    </message>
    <message>
        <source>Motors were commanded to stop. Until answers have been correct for 2 s, only presence queries are sent; then the panel looks for the modules again. Try a lower baud rate, a shorter cable, or termination at both ends.</source>
        <translation>モーターに停止を指令しました。正しい応答が2秒続くまで、モジュールの存在確認だけを送信します。その後、パネルが再スキャンします。ボーレートを下げるか、短いケーブル、または両端の終端を試してください。</translation>
    </message>
    <message>
        <source>%1 is %2; the module accepts %3 to %4.</source>
        <translation>%1は%2ですが、モジュールが受け付けるのは%3～%4です。</translation>
    </message>
    <message numerus="yes">
        <source>%n stopped and holding</source>
        <translation>
            <numerusform>%n台が停止して保持中</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n switched off</source>
        <translation>
            <numerusform>%n台をオフにしました</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n were off</source>
        <translation>
            <numerusform>%n台は元からオフ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n I/O modules in their stop state</source>
        <translation>
            <numerusform>I/Oモジュール%n台は停止時の設定どおり</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 ms.</source>
        <translation>%1、%2 ms。</translation>
    </message>
    <message>
        <source>Module %1 was commanded to switch off: one answer reported a move in the wrong direction, to %2 counts.</source>
        <translation>モジュール%1にモーターオフを指令しました。誤った方向に動き、位置%2カウントに達したという応答が1つあったためです。</translation>
    </message>
    <message>
        <source>If it did, encoder or motor wires are swapped, or the gains make it oscillate. If it did not, the answer was wrong: check the cable.</source>
        <translation>事実なら、エンコーダー線またはモーター線の逆接続か、ゲインによる発振です。位置が正しければ、別のモジュールの応答です。ケーブルを確認してください。</translation>
    </message>
    <message>
        <source>Module %1 was commanded to stop: one answer reported that it went past its goal, to %2 counts.</source>
        <translation>モジュール%1に停止を指令しました。目標位置を行き過ぎ、位置%2カウントに達したという応答が1つあったためです。</translation>
    </message>
    <message>
        <source>Check the position before the next move. If it went there, the command was corrupted in transit, or the gains cause a large overshoot. If it did not, the answer was wrong: check the cable.</source>
        <translation>次の移動の前に位置を確認してください。そこまで動いていれば、コマンドが途中で壊れたか、ゲインのためにオーバーシュートが大きくなっています。動いていなければ、別のモジュールの応答です。ケーブルを確認してください。</translation>
    </message>
    <message>
        <source>A question is waiting for your answer: %1</source>
        <translation>質問への回答待ちです：%1</translation>
    </message>
    <message>
        <source>Show the question</source>
        <translation>質問を表示</translation>
    </message>
    <message>
        <source>Maybe off</source>
        <translation>オフの可能性</translation>
    </message>
    <message>
        <source>Maybe moving</source>
        <translation>動作中の可能性</translation>
    </message>
    <message>
        <source>One answer says that the motor is off. The next answer will show whether it is.</source>
        <translation>モジュールがモーターをオフにしたという応答が1つありました。次の応答で分かります。</translation>
    </message>
    <message>
        <source>The last answers show the motor at rest, but it is not yet known whether it was started.</source>
        <translation>最近の応答ではモーターは停止していますが、始動したかどうかはまだ不明です。</translation>
    </message>
    <message>
        <source>Looking for modules… Until they are found, only stop commands work.</source>
        <translation>モジュールを検索中… 見つかるまでは、停止だけが有効です。</translation>
    </message>
    <message>
        <source>The servo rate of this module is unknown, so speeds per second cannot be calculated. Apply its gains first: they include SR.</source>
        <translation>このモジュールのサーボレートが不明なため、1秒あたりの速度も不明です。先にゲインを適用してください。SRはゲインに含まれます。</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>疑わしい値</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>%1秒前</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>古い値</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has one column per signal, a format for other programs. The scope opens files with one row per reply.</source>
        <translation>「%1」は信号ごとに1列で、ほかのプログラム用の形式です。スコープで開けるのは、応答ごとに1行のファイルです。</translation>
    </message>
    <message>
        <source>The position counter of module %1 has wrapped.</source>
        <translation>モジュール%1の位置が桁あふれしました。</translation>
    </message>
    <message>
        <source>The 32-bit counter has overflowed and continues at the other end of its range. Earlier positions and travel limits no longer match: find home, then clear the sticky bits on the Details page.</source>
        <translation>32ビットの範囲の反対側の端から続いています。以前の位置や移動範囲はもう元の場所を指しません。原点復帰を行い、「詳細」ページでスティッキービットをクリアしてください。</translation>
    </message>
    <message>
        <source>Limit switch 1 is active: the motor can only move away from it.</source>
        <translation>リミットスイッチ1がオンです。モーターはそこから離れる方向にだけ動けます。</translation>
    </message>
    <message>
        <source>Limit switch 2 is active: the motor can only move away from it.</source>
        <translation>リミットスイッチ2がオンです。モーターはそこから離れる方向にだけ動けます。</translation>
    </message>
    <message>
        <source>program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>%1 is not a line behind a network.</source>
        <translation>%1 はネットワーク越しの回線ではありません。</translation>
    </message>
    <message>
        <source>Write tcp://HOST:PORT, or rfc2217://HOST:PORT if the device server lets the rate be set.</source>
        <translation>tcp://HOST:PORT と書くか、デバイスサーバーがボーレートの設定を許す場合は rfc2217://HOST:PORT と書いてください。</translation>
    </message>
    <message>
        <source>The computer or device server in %1 was not found.</source>
        <translation>%1 のコンピューターまたはデバイスサーバーが見つかりません。</translation>
    </message>
    <message>
        <source>Check its name, and the network.</source>
        <translation>名前とネットワークを確認してください。</translation>
    </message>
    <message>
        <source>Nothing accepts connections at %1.</source>
        <translation>%1 で接続を受け付けるものがありません。</translation>
    </message>
    <message>
        <source>Check that the device server is on, that its TCP port is this one, and that no other program has it.</source>
        <translation>デバイスサーバーの電源、TCP ポート番号、ほかのプログラムが使用していないことを確認してください。</translation>
    </message>
    <message>
        <source>%1 does not let the serial port be controlled.</source>
        <translation>%1 ではシリアルポートを制御できません。</translation>
    </message>
    <message>
        <source>Enable RFC 2217 in the device server, or set it to 19 200 Bd, 8N1, and connect with tcp:// instead.</source>
        <translation>デバイスサーバーで RFC 2217 を有効にするか、19 200 Bd、8N1 に設定して代わりに tcp:// で接続してください。</translation>
    </message>
    <message>
        <source>The connection to %1 is lost. %2</source>
        <translation>%1 への接続が失われました。%2</translation>
    </message>
    <message>
        <source>Use the hardware stop if needed, then check the network and the device server.</source>
        <translation>必要ならハードウェア停止装置を使用し、その後ネットワークとデバイスサーバーを確認してください。</translation>
    </message>
    <message>
        <source>The line is lent to a program.</source>
        <translation>回線はプログラムに貸出中です。</translation>
    </message>
    <message>
        <source>Connected to %1 at %2 Bd, %3, lent to a program</source>
        <translation>%1 に接続中(%2 Bd、%3、プログラムに貸出中)</translation>
    </message>
    <message>
        <source>Settings copied from %1: %2.</source>
        <translation>%1 からコピーした設定: %2。</translation>
    </message>
    <message>
        <source>The move and the record after it would take more than 6 s. Shorten the move or the record, or move faster.</source>
        <translation>移動とその後の記録が 6 s を超えます。移動または記録を短くするか、速度を上げてください。</translation>
    </message>
    <message>
        <source>The motor swung so far that it reversed, and was commanded to hold. Raise the speed, or lower the amplitude.</source>
        <translation>モーターの振れが大きく反転したため、保持を指令しました。速度を上げるか、振幅を小さくしてください。</translation>
    </message>
    <message>
        <source>At this speed the motor would reverse. Raise the speed, or lower the amplitude or the highest frequency.</source>
        <translation>この速度ではモーターが反転します。速度を上げるか、振幅または最高周波数を下げてください。</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容差</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, from home</source>
        <translation>「%1」、原点から</translation>
    </message>
    <message>
        <source>%1 did not stay within its arrival tolerance. Check its gains, or change the tolerance (Axis page).</source>
        <translation>%1は到着許容差内にとどまりませんでした。ゲインを確認するか、許容差を変更してください（軸ページ）。</translation>
    </message>
    <message>
        <source>The motor would come too close to the position error limit, which switches the servo off. Make the step, the amplitude or the speed smaller, or raise EL.</source>
        <translation>モーターが位置偏差上限に近づきすぎて、サーボがオフになります。ステップ、振幅または速度を小さくするか、ELを上げてください。</translation>
    </message>
    <message>
        <source>%1 did not finish its approaches.</source>
        <translation>%1の接近が完了しませんでした。</translation>
    </message>
    <message>
        <source>Reading the captured position</source>
        <translation>捕捉位置を読み取り中</translation>
    </message>
    <message>
        <source>The switch changed again while the motor stopped beyond it: it bounces, or its cam is too short. The motor is at rest. Move more slowly, or raise the acceleration.</source>
        <translation>モーターがスイッチを越えて停止する間に、スイッチがもう一度変化しました。チャタリングしているか、ドグが短すぎます。モーターは停止しています。速度を下げるか、加速度を上げてください。</translation>
    </message>
    <message>
        <source>The switch or index did not change within the search distance and the time limit. It may be stuck, closed on both sides, or in the other direction; above 1 count per tick, an index can be missed. The motor was stopped.</source>
        <translation>サーチ距離と制限時間の範囲でスイッチまたはインデックスが変化しませんでした。固着している、両側で閉じている、または反対方向にある可能性があります。1周期あたり1カウントを超えると、インデックスを見逃すことがあります。モーターを停止しました。</translation>
    </message>
    <message>
        <source>The switch or index did not change within the travel limits. The motor was stopped.</source>
        <translation>移動範囲内でスイッチまたはインデックスが変化しませんでした。モーターを停止しました。</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input ended the motion before the switch changed. The motor is at rest.</source>
        <translation>スイッチが変化する前に、リミットスイッチまたは非常停止入力で動作が終了しました。モーターは停止しています。</translation>
    </message>
    <message>
        <source>Choose one switch or the index, and nothing else.</source>
        <translation>スイッチ1つまたはインデックスだけを選択してください。</translation>
    </message>
    <message>
        <source>Approach it 2 to 100 times from each side.</source>
        <translation>各側からの接近は2～100回にしてください。</translation>
    </message>
    <message>
        <source>An earlier stop was not confirmed, so it was sent now.</source>
        <translation>以前の停止が確認されていなかったため、今送信しました。</translation>
    </message>
    <message>
        <source>No stop can be sent now: use the hardware stop.</source>
        <translation>現在、停止を送信できません。ハードウェア停止装置を使用してください。</translation>
    </message>
    <message>
        <source>It is sent as soon as you connect to the same modules again.</source>
        <translation>同じモジュールに再び接続すると、すぐに送信されます。</translation>
    </message>
    <message>
        <source>Not connected: the state of the chain is unknown.</source>
        <translation>未接続：チェーンの状態は不明です。</translation>
    </message>
    <message>
        <source>Chain OK: %1.</source>
        <translation>チェーン正常：%1。</translation>
    </message>
    <message>
        <source>No module answered.</source>
        <translation>応答したモジュールはありません。</translation>
    </message>
    <message>
        <source>%1 of %2 modules answered; the far end of the chain is missing.</source>
        <translation>%2台中%1台のモジュールが応答しました。チェーンの遠端側が見つかりません。</translation>
    </message>
    <message>
        <source>%1 is not the expected module.</source>
        <translation>%1は想定と異なるモジュールです。</translation>
    </message>
    <message>
        <source>More modules than expected: %1 instead of %2.</source>
        <translation>モジュールが想定より多く見つかりました：%2に対して%1。</translation>
    </message>
    <message>
        <source>%1 stopped answering. Motor state unknown.</source>
        <translation>%1が応答しなくなりました。モーターの状態は不明です。</translation>
    </message>
    <message>
        <source>%1 restarted: its position and gains are lost.</source>
        <translation>%1が再起動しました。位置とゲインは失われました。</translation>
    </message>
    <message>
        <source>%1 restarted: its pins are inputs again, and its outputs release what they drove.</source>
        <translation>%1が再起動しました。ピンは入力に戻り、出力は駆動をやめました。</translation>
    </message>
    <message>
        <source>%1 restarted: its position and parameters are lost.</source>
        <translation>%1が再起動しました。位置とパラメーターは失われました。</translation>
    </message>
    <message>
        <source>Choose a port and connect.</source>
        <translation>ポートを選択して接続してください。</translation>
    </message>
    <message>
        <source>Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC.</source>
        <translation>次の順に確認してください：モジュールの電源、チェーンの全ケーブル（1本の緩みですべてのモジュールが見えなくなります）、PCから最も遠いモジュールのADDR_INジャンパー。</translation>
    </message>
    <message>
        <source>Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two. Then scan again.</source>
        <translation>番号は遠端から始まります。%1の次の、PC側のモジュールを調べてください。まずその電源、次に両者の間のプラグです。その後、再スキャンしてください。</translation>
    </message>
    <message>
        <source>Only the modules nearest the PC answered, and their numbers have changed. Check the cable to the module at the far end, and check that no other ADDR_IN is grounded. Until this is fixed, settings do not match the modules.</source>
        <translation>PCに近いモジュールだけが応答し、番号が変わっています。遠端のモジュールへのケーブルと、ほかのADDR_INが接地されていないことを確認してください。修復するまで、設定とモジュールは一致しません。</translation>
    </message>
    <message>
        <source>Name, unit, limits, speeds and points of the expected module are used for it; gains and parameters from a machine file are not sent to it. If you replaced the module on purpose, check these settings, then accept the chain as found.</source>
        <translation>想定モジュールの名前、単位、リミット、速度、ポイントがこのモジュールにも使われます。マシンファイルのゲインとパラメーターは送信されません。意図して交換した場合は、これらの設定を確認してから、検出結果を採用してください。</translation>
    </message>
    <message>
        <source>The settings of this place are for another type of module, so they are not used, and only stop commands work. Check the cables, then scan again. If you replaced the module on purpose, accept the chain as found (Chain doctor): all but its name is then to be set again, and its positions leave the points.</source>
        <translation>この場所の設定は別の種類のモジュールのものなので使われず、停止だけが有効です。ケーブルを確認してから、再スキャンしてください。意図して交換した場合は、検出結果を採用してください（チェーン診断）。その場合、名前以外はすべて設定し直しとなり、この軸の位置はポイントから除かれます。</translation>
    </message>
    <message>
        <source>Modules from %1 on are new. If they belong there, accept the chain as found.</source>
        <translation>%1以降のモジュールは新規です。これが正しい場合は、検出結果を採用してください。</translation>
    </message>
    <message>
        <source>Check its power and cable; use the hardware stop if its motor moves. The panel retries from time to time.</source>
        <translation>電源とケーブルを確認してください。モーターが動く場合はハードウェア停止装置を使用してください。パネルは時々再試行します。</translation>
    </message>
    <message>
        <source>Modules between it and the PC may not answer until it has its address again. Restart the network when it is safe to stop all motors and lose their positions.</source>
        <translation>このモジュールとPCの間にあるモジュールは、アドレスが戻るまで応答しないことがあります。すべてのモーターを停止でき、位置を失ってもよい状態になったら、ネットワークを再起動してください。</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>different module</source>
        <translation>別のモジュール</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>問い合わせ停止</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>再起動</translation>
    </message>
    <message>
        <source>no group</source>
        <translation>グループなし</translation>
    </message>
    <message>
        <source>This chain is new: it has %1.</source>
        <translation>新しいチェーンです：%1。</translation>
    </message>
    <message>
        <source>Compare the list with the labels on the modules, starting with the module farthest from the PC. If it is right, accept the chain as found: from then on, missing and replaced modules are reported.</source>
        <translation>PCから最も遠いモジュールから順に、一覧とモジュールのラベルを照合してください。正しければ検出結果を採用してください。以後、モジュールの欠落や交換が通知されます。</translation>
    </message>
    <message>
        <source>Looking for modules…</source>
        <translation>モジュールを検索中…</translation>
    </message>
    <message>
        <source>Home: %1</source>
        <translation>原点：%1</translation>
    </message>
    <message>
        <source>Home: unknown</source>
        <translation>原点：不明</translation>
    </message>
    <message>
        <source>Home is unknown. Search for home, or move there and choose Save as home. A restart of the module loses home again.</source>
        <translation>原点は不明です。原点サーチを行うか、原点に移動して「原点として保存」を選択してください。モジュールが再起動すると、原点は再び失われます。</translation>
    </message>
    <message>
        <source>Home is at %1. A search found it %2 min ago.</source>
        <translation>原点は%1にあります。%2分前に原点サーチで検出しました。</translation>
    </message>
    <message>
        <source>Home is at %1. It was saved %2 min ago.</source>
        <translation>原点は%1にあります。%2分前に保存しました。</translation>
    </message>
    <message>
        <source>Makes the present position 0. The motor does not move. The old zero is lost: from then on all positions count from here.</source>
        <translation>現在位置を0にします。モーターは動きません。元の0は失われ、以後の位置はすべてここから数えます。</translation>
    </message>
    <message>
        <source>This moves home from %1 to %2.</source>
        <translation>原点が%1から%2に移ります。</translation>
    </message>
    <message>
        <source>The position that the chip captured or saved last. A limit stop changes it, too; Zero here does not. Go home does not use it.</source>
        <translation>チップが最後に取り込んだ、または保存した位置です。リミット停止でも変わりますが、「現在位置を0に」では変わりません。「原点へ移動」では使用しません。</translation>
    </message>
    <message>
        <source>Home: %1, not verified</source>
        <translation>原点：%1、未確認</translation>
    </message>
    <message>
        <source>Home is at %1, not verified: restored %2 min ago from the last known position. Search for home to verify it.</source>
        <translation>原点は%1です（未確認）：最後に分かっていた位置から%2分前に復元しました。確認するには原点サーチを行ってください。</translation>
    </message>
    <message>
        <source>Home is at %1. You confirmed the position %2 min ago.</source>
        <translation>原点は%1にあります。%2分前に位置を確認済みです。</translation>
    </message>
    <message>
        <source>That is %1; this module can be given at most %2.</source>
        <translation>この値は%1です。このモジュールに送れる最高速度は%2です。</translation>
    </message>
    <message>
        <source>That is %1; the highest velocity of this axis is %2 (Axis page).</source>
        <translation>この値は%1です。この軸の最高速度は%2です（「軸」ページ）。</translation>
    </message>
    <message>
        <source>Lowest position reached: %1. Move forward.</source>
        <translation>最小位置に達しました：%1。正方向に動かしてください。</translation>
    </message>
    <message>
        <source>Highest position reached: %1. Move in reverse.</source>
        <translation>最大位置に達しました：%1。逆方向に動かしてください。</translation>
    </message>
    <message>
        <source>No travel limits are set.</source>
        <translation>移動範囲は設定されていません。</translation>
    </message>
    <message>
        <source>Not in force: home is unknown. Search for it, save it, or confirm the position.</source>
        <translation>無効：原点が不明です。原点サーチ、原点の保存、または位置の確認を行ってください。</translation>
    </message>
    <message>
        <source>In force: not below %1.</source>
        <translation>有効：%1以上。</translation>
    </message>
    <message>
        <source>In force: not above %1.</source>
        <translation>有効：%1以下。</translation>
    </message>
    <message>
        <source>In force: from %1 to %2.</source>
        <translation>有効：%1～%2。</translation>
    </message>
    <message>
        <source>Travel limits not in force</source>
        <translation>移動範囲の制限が無効</translation>
    </message>
    <message>
        <source>At the lowest position</source>
        <translation>最小位置に到達</translation>
    </message>
    <message>
        <source>At the highest position</source>
        <translation>最大位置に到達</translation>
    </message>
    <message>
        <source>Below the lowest position</source>
        <translation>最小位置未満</translation>
    </message>
    <message>
        <source>Above the highest position</source>
        <translation>最大位置超過</translation>
    </message>
    <message>
        <source>Look at the axis first: is %1 really at %2? If so, home is at position 0, and the travel limits apply from there. If not, they protect the wrong range.</source>
        <translation>先に軸を目視で確認してください。%1は本当に%2にありますか？正しければ、位置0が原点となり、そこを基準に移動範囲が適用されます。正しくなければ、誤った範囲を保護することになります。</translation>
    </message>
    <message>
        <source>To take up the backlash, the move would reverse at %1, below the lowest position %2. Lower that position, or change the backlash or its direction (Axis page).</source>
        <translation>バックラッシを取るには%1で折り返す必要がありますが、最小位置%2を下回ります。その位置を下げるか、バックラッシまたはその方向を変更してください（「軸」ページ）。</translation>
    </message>
    <message>
        <source>To take up the backlash, the move would reverse at %1, above the highest position %2. Raise that position, or change the backlash or its direction (Axis page).</source>
        <translation>バックラッシを取るには%1で折り返す必要がありますが、最大位置%2を上回ります。その位置を上げるか、バックラッシまたはその方向を変更してください（「軸」ページ）。</translation>
    </message>
    <message>
        <source>That is beyond the travel limits: the lowest position is %1 (Axis page).</source>
        <translation>移動範囲を超えています：最小位置は%1です（「軸」ページ）。</translation>
    </message>
    <message>
        <source>That is beyond the travel limits: the highest position is %1 (Axis page).</source>
        <translation>移動範囲を超えています：最大位置は%1です（「軸」ページ）。</translation>
    </message>
    <message>
        <source>The highest velocity is set on the Axis page.</source>
        <translation>最高速度は「軸」ページで設定します。</translation>
    </message>
    <message>
        <source>The max jog speed and the highest velocity are set on the Axis page.</source>
        <translation>最高ジョグ速度と最高速度は「軸」ページで設定します。</translation>
    </message>
    <message>
        <source>from &quot;%1&quot;</source>
        <translation>「%1」から</translation>
    </message>
    <message>
        <source>%1 by the counter</source>
        <translation>カウンター値%1</translation>
    </message>
    <message>
        <source>Positions count from &quot;%1&quot;.</source>
        <translation>位置は「%1」から数えます。</translation>
    </message>
    <message>
        <source>It is not known any more where &quot;%1&quot; is. Choose the work offset again, or clear it (Axis page).</source>
        <translation>「%1」の位置が不明になりました。ワークオフセットを選択し直すか、解除してください（軸ページ）。</translation>
    </message>
    <message>
        <source>steps/s²</source>
        <translation>ステップ/s²</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>カウント/s</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>カウント/s²</translation>
    </message>
    <message>
        <source>%1 (%2 of 255)</source>
        <translation>%1 (%2 / 255)</translation>
    </message>
    <message>
        <source>Oscillating ± %1 at about %2 Hz</source>
        <translation>発振 ± %1、約%2 Hz</translation>
    </message>
    <message>
        <source>Oscillating ± %1</source>
        <translation>発振 ± %1</translation>
    </message>
    <message>
        <source>Hunting ± %1 every %2 s. Lower Ki.</source>
        <translation>ハンチング ± %1、周期 %2 s。Kiを下げてください。</translation>
    </message>
    <message>
        <source>%1, hunting</source>
        <translation>%1、ハンチング</translation>
    </message>
    <message>
        <source>%1, oscillating</source>
        <translation>%1、発振中</translation>
    </message>
    <message>
        <source>%1, pushing at OL</source>
        <translation>%1、OLで押しています</translation>
    </message>
    <message>
        <source>%1, %2 off</source>
        <translation>%1、ずれ %2</translation>
    </message>
    <message>
        <source>Kp is 0: the servo brakes the motor but holds no position.</source>
        <translation>Kpが0です。サーボはモーターを制動しますが、位置は保持しません。</translation>
    </message>
    <message>
        <source>%1 off the position to hold, and pushing with up to the full output limit. Something may be in the way.</source>
        <translation>保持すべき位置から%1ずれ、最大で出力制限いっぱいまで押しています。何かが妨げている可能性があります。</translation>
    </message>
    <message>
        <source>%1 off the position to hold: friction, a load or an obstacle is stronger. A higher Kp, or an integral (Ki, IL), pushes more.</source>
        <translation>保持すべき位置から%1ずれています。摩擦、負荷、または障害物の力が上回っています。Kpを上げるか、積分（Ki、IL）を使うと、より強く押します。</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; is missing.</source>
        <translation>パラメーター「%1」がありません。</translation>
    </message>
    <message>
        <source>These parameters are missing: %1.</source>
        <translation>次のパラメーターがありません: %1。</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; has the wrong type, or is out of its range.</source>
        <translation>パラメーター「%1」の型が正しくないか、範囲外です。</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; must be from %2 to %3 here.</source>
        <translation>パラメーター「%1」は、ここでは%2から%3まででなければなりません。</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; must be from %2 to %3 here, in either direction. %3 is the max jog speed of the axis.</source>
        <translation>パラメーター「%1」は、ここでは向きを問わず%2から%3まででなければなりません。%3はこの軸の最高ジョグ速度です。</translation>
    </message>
    <message>
        <source>There is no such axis.</source>
        <translation>そのような軸はありません。</translation>
    </message>
    <message>
        <source>There is no sequence or point of that name.</source>
        <translation>その名前のシーケンスまたはポイントはありません。</translation>
    </message>
    <message>
        <source>This program may not move motors now: call request_control first.</source>
        <translation>このプログラムは現在モーターを動かせません。先にrequest_controlを呼び出してください。</translation>
    </message>
    <message>
        <source>Call hello first.</source>
        <translation>先にhelloを呼び出してください。</translation>
    </message>
    <message>
        <source>This panel speaks version %1 of the protocol, and the program version %2.</source>
        <translation>このパネルのプロトコルはバージョン%1、プログラムのプロトコルはバージョン%2です。</translation>
    </message>
    <message>
        <source>It was cancelled by a stop or by another command.</source>
        <translation>停止または別のコマンドによって取り消されました。</translation>
    </message>
    <message>
        <source>Motors were stopped.</source>
        <translation>モーターが停止されました。</translation>
    </message>
    <message>
        <source>The user has taken control back.</source>
        <translation>ユーザーが操作権を取り戻しました。</translation>
    </message>
    <message>
        <source>The user has commanded a motor.</source>
        <translation>ユーザーがモーターに指令しました。</translation>
    </message>
    <message>
        <source>The chain is no longer connected.</source>
        <translation>チェーンはもう接続されていません。</translation>
    </message>
    <message>
        <source>Other programs cannot connect.</source>
        <translation>他のプログラムは接続できません。</translation>
    </message>
    <message>
        <source>Another panel already lets programs in at %1.</source>
        <translation>別のパネルが、すでに%1でプログラムの接続を許可しています。</translation>
    </message>
    <message>
        <source>%1 is a link, belongs to another user, or is open to others. Remove it, and try again.</source>
        <translation>%1はリンクであるか、他のユーザーの所有であるか、他のユーザーに公開されています。削除してから、もう一度お試しください。</translation>
    </message>
    <message>
        <source>%1 cannot be created.</source>
        <translation>%1を作成できません。</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has connected. It may read, stop motors and switch them off, but not move them.</source>
        <translation>プログラム「%1」が接続しました。読み取りと、モーターの停止やオフはできますが、モーターは動かせません。</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has disconnected; the motors that it moved are stopped.</source>
        <translation>プログラム「%1」が切断しました。このプログラムが動かしたモーターを停止します。</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot; has disconnected.</source>
        <translation>プログラム「%1」が切断しました。</translation>
    </message>
    <message>
        <source>Program &quot;%1&quot;: %2</source>
        <translation>プログラム「%1」：%2</translation>
    </message>
    <message>
        <source>This line is not JSON.</source>
        <translation>この行は JSON ではありません。</translation>
    </message>
    <message>
        <source>A request is an object with method, params (an object) and id.</source>
        <translation>リクエストは method、params(オブジェクト)、id を持つオブジェクトです。</translation>
    </message>
    <message>
        <source>There is no such method.</source>
        <translation>そのメソッドはありません。</translation>
    </message>
    <message>
        <source>The line is lent at %1. No program has used it yet.</source>
        <translation>回線を %1 で貸しています。まだプログラムは使用していません。</translation>
    </message>
    <message>
        <source>A program has the line, at %1.</source>
        <translation>プログラムが %1 で回線を使用しています。</translation>
    </message>
    <message>
        <source>All motors were commanded to stop, and the program is held off.</source>
        <translation>すべてのモーターに停止を指令し、プログラムを保留しました。</translation>
    </message>
    <message>
        <source>What it sends is dropped. Release lets it continue; it does not know what it has missed.</source>
        <translation>送信内容は破棄されます。「続行させる」で再開しますが、プログラムは抜けた分を知りません。</translation>
    </message>
    <message>
        <source>The program has closed %1, and the line is no longer lent.</source>
        <translation>プログラムが %1 を閉じたので、回線の貸出は終わりました。</translation>
    </message>
    <message>
        <source>The line is no longer lent.</source>
        <translation>回線の貸出は終わりました。</translation>
    </message>
    <message>
        <source>The line was not lent.</source>
        <translation>回線は貸し出されませんでした。</translation>
    </message>
    <message>
        <source>The chain was busy, or a motor was moving. Stop the motors, and try again.</source>
        <translation>チェーンが使用中か、モーターが動いていました。モーターを停止してやり直してください。</translation>
    </message>
    <message>
        <source>There is something at %1 already. Choose another path.</source>
        <translation>%1 には既に何かがあります。別のパスを選んでください。</translation>
    </message>
    <message>
        <source>No terminal can be made at %1. Choose a path in a folder of your own.</source>
        <translation>%1 に端末を作れません。自分のフォルダー内のパスを選んでください。</translation>
    </message>
    <message>
        <source>LENT at %1 — stopped; the program is held off.</source>
        <translation>貸出中 %1 — 停止しました。プログラムは保留中です。</translation>
    </message>
    <message>
        <source>LENT at %1 — a program has the line. No travel limit or other check of the panel protects the motors; STOP ALL does.</source>
        <translation>貸出中 %1 — プログラムが回線を使用しています。移動範囲などパネルの確認はモーターを保護しません。全停止は有効です。</translation>
    </message>
    <message>
        <source>LENT at %1 — no program yet.</source>
        <translation>貸出中 %1 — まだプログラムはありません。</translation>
    </message>
    <message>
        <source>The motor did not stay within the arrival tolerance of its axis.</source>
        <translation>モーターが軸の到着許容差内にとどまりませんでした。</translation>
    </message>
    <message>
        <source>This pin is not set as an output. Make it an output first.</source>
        <translation>このピンは出力に設定されていません。先に出力に設定してください。</translation>
    </message>
    <message>
        <source>The outputs of this module, or their directions, are unknown. Set them once first.</source>
        <translation>このモジュールの出力またはその方向が不明です。先に一度設定してください。</translation>
    </message>
    <message>
        <source>Several axes have this name. Use the number of the axis, or give each its own name.</source>
        <translation>同じ名前の軸が複数あります。軸の番号を使うか、それぞれに別の名前を付けてください。</translation>
    </message>
</context>
<context>
    <name>nmc::AmplifierBox</name>
    <message>
        <source>3-phase commutation</source>
        <translation>三相転流</translation>
    </message>
    <message>
        <source>For a brushless motor with Hall sensors and a 3-phase amplifier. Off: a brush motor.</source>
        <translation>ホールセンサー付きブラシレスモーターと三相アンプ用です。オフ：ブラシ付きモーター。</translation>
    </message>
    <message>
        <source>Antiphase PWM</source>
        <translation>アンチフェーズPWM</translation>
    </message>
    <message>
        <source>For a locked-antiphase amplifier: 50 % PWM is zero output. Off: PWM and direction.</source>
        <translation>50% PWMを停止とみなすアンプ用です。オフ：PWMと方向。</translation>
    </message>
    <message>
        <source>Step and direction input</source>
        <translation>ステップ/方向入力</translation>
    </message>
    <message>
        <source>The motor follows step pulses at the limit pins instead of commands. The limit inputs then give no protection.</source>
        <translation>モーターはコマンドではなく、リミットピンのステップパルスに追従します。リミットによる保護はなくなります。</translation>
    </message>
    <message>
        <source>Path points at 60 and 120 Hz instead of 30 and 60 Hz.</source>
        <translation>パスの点は30/60 Hzではなく、60/120 Hzになります。</translation>
    </message>
    <message>
        <source>Apply…</source>
        <translation>適用…</translation>
    </message>
    <message>
        <source>Apply the amplifier settings</source>
        <translation>適用：アンプ設定</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Set the step multiplier</source>
        <translation>設定：ステップ倍率</translation>
    </message>
    <message>
        <source>Keep its address and group</source>
        <translation>アドレスとグループを保持</translation>
    </message>
    <message>
        <source>It comes back at this address after a power cycle, without a search.</source>
        <translation>電源を入れ直しても、検索なしでこのアドレスに戻ります。</translation>
    </message>
    <message>
        <source>Amplifier on at power-up</source>
        <translation>電源投入時にアンプオン</translation>
    </message>
    <message>
        <source>AMP_EN goes high by itself after each power-up.</source>
        <translation>電源投入のたびに、AMP_ENが自動でHighになります。</translation>
    </message>
    <message>
        <source>Servo on at power-up</source>
        <translation>電源投入時にサーボオン</translation>
    </message>
    <message>
        <source>The servo switches on by itself after each power-up, with the saved gains, even with no panel connected.</source>
        <translation>電源投入のたびに、パネルの接続前でも、保存したゲインでモーターが自動で保持を始めます。</translation>
    </message>
    <message>
        <source>Save in module…</source>
        <translation>モジュールに保存…</translation>
    </message>
    <message>
        <source>Save in module: configuration for power-up</source>
        <translation>モジュールに保存：電源投入時の構成</translation>
    </message>
    <message>
        <source>Erase saved…</source>
        <translation>保存内容を消去…</translation>
    </message>
    <message>
        <source>Erase saved configuration of the module</source>
        <translation>保存内容を消去：モジュールの保存済み構成</translation>
    </message>
    <message>
        <source>Limit inputs</source>
        <translation>リミット入力</translation>
    </message>
    <message>
        <source>do nothing</source>
        <translation>何もしない</translation>
    </message>
    <message>
        <source>stop abruptly</source>
        <translation>即停止</translation>
    </message>
    <message>
        <source>switch the motor off</source>
        <translation>モーターオフ</translation>
    </message>
    <message>
        <source>Amplifier settings of the module</source>
        <translation>モジュールのアンプ設定</translation>
    </message>
    <message>
        <source>Step multiplier</source>
        <translation>ステップ倍率</translation>
    </message>
    <message>
        <source>Counts that one step pulse moves the motor.</source>
        <translation>ステップパルス1個でモーターが動くカウント数です。</translation>
    </message>
    <message>
        <source>Saved in the module, for power-up</source>
        <translation>モジュールに保存（電源投入時用）</translation>
    </message>
    <message>
        <source>Saves these choices, the settings above, the gains, the velocity and the acceleration as the module has them now. They come back at each power-up. 3-phase and antiphase come back after a reset, too. Both buttons restart the module: its motor switches off, and it needs its gains again.</source>
        <translation>これらの選択、上の設定、および現在モジュールにあるゲイン、速度、加速度を保存します。電源投入のたびに復元されます。三相とアンチフェーズは、リセット後にも復元されます。どちらのボタンもモジュールを再起動します。モーターはオフになり、ゲインを再度送る必要があります。</translation>
    </message>
    <message>
        <source>? Unknown: nothing has been applied in this connection, and the settings cannot be read back. The module may have saved settings.</source>
        <translation>? 不明：この接続では何も適用しておらず、モジュールからは読み出せません。保存済みの設定がある可能性があります。</translation>
    </message>
    <message>
        <source>✓ Applied: 3-phase %1, antiphase %2, step and direction %3, limits %4.</source>
        <translation>✓ 適用済み：三相 %1、アンチフェーズ %2、ステップ/方向 %3、リミット %4。</translation>
    </message>
    <message>
        <source>Step and direction uses the limit pins: set the limit inputs to do nothing.</source>
        <translation>ステップ/方向では、リミットのピンがその入力になります。リミット入力を「何もしない」に設定してください。</translation>
    </message>
    <message>
        <source>The module already has these settings.</source>
        <translation>モジュールはこの設定になっています。</translation>
    </message>
    <message>
        <source>Takes AMP_EN low and sends these settings.</source>
        <translation>AMP_ENをLowにして、この設定を送信します。</translation>
    </message>
    <message>
        <source>Sends the module&apos;s present gains with this multiplier.</source>
        <translation>現在モジュールにあるゲインを、この倍率とともに送信します。</translation>
    </message>
    <message>
        <source>Apply the amplifier settings first: the module&apos;s present settings are unknown.</source>
        <translation>先にアンプ設定を適用してください。モジュールの現在の設定が不明です。</translation>
    </message>
    <message>
        <source>Saves the module&apos;s present settings and restarts it.</source>
        <translation>現在のモジュールの内容を保存し、再起動します。</translation>
    </message>
    <message>
        <source>Erases the module&apos;s saved configuration and restarts it.</source>
        <translation>モジュールの保存内容を消去し、再起動します。</translation>
    </message>
    <message>
        <source>Apply amplifier settings</source>
        <translation>アンプ設定の適用</translation>
    </message>
    <message>
        <source>Apply these settings to %1? If 3-phase, antiphase or step and direction do not match the amplifier and its wiring, the amplifier can be destroyed, or the motor can run away once it is enabled.</source>
        <translation>この設定を%1に適用しますか？三相、アンチフェーズ、ステップ/方向がアンプや配線に合わないと、アンプが破損するか、オンにしたときにモーターが暴走するおそれがあります。</translation>
    </message>
    <message>
        <source>Apply settings</source>
        <translation>設定を適用</translation>
    </message>
    <message>
        <source>Save the configuration of %1? It takes effect at each power-up, whatever is connected then. The module restarts now: its motor switches off, and it needs its gains again.</source>
        <translation>%1の構成を保存しますか？何が接続されていても、電源投入のたびに復元されます。モジュールは今すぐ再起動します。モーターはオフになり、ゲインを再度送る必要があります。</translation>
    </message>
    <message>
        <source>Its motor will be driven right after power-up, without a command.</source>
        <translation>電源投入の直後に、コマンドなしでモーターが駆動されます。</translation>
    </message>
    <message>
        <source>Save in module</source>
        <translation>モジュールに保存</translation>
    </message>
    <message>
        <source>Save and restart</source>
        <translation>保存して再起動</translation>
    </message>
    <message>
        <source>Erase saved configuration</source>
        <translation>保存済み構成の消去</translation>
    </message>
    <message>
        <source>Erase the saved configuration of %1? From the next power-up it starts with its default settings. It restarts now: its motor switches off, and it needs its gains again.</source>
        <translation>%1の保存内容を消去しますか？次の電源投入時には、新品のモジュールと同じ状態で起動します。モジュールは今すぐ再起動します。モーターはオフになり、ゲインを再度送る必要があります。</translation>
    </message>
    <message>
        <source>Erase and restart</source>
        <translation>消去して再起動</translation>
    </message>
    <message>
        <source>What the module does by itself when limit 1 closes while it counts up, or limit 2 while it counts down. It stays armed.</source>
        <translation>カウントが増えている間にリミット1、または減っている間にリミット2が閉じたとき、モジュールが自動で行う動作です。作動後も有効なままです。</translation>
    </message>
    <message>
        <source>Undo the last edit of the amplifier settings</source>
        <translation>元に戻す：アンプ設定の最後の編集</translation>
    </message>
    <message>
        <source>Redo the edit of the amplifier settings</source>
        <translation>やり直し：アンプ設定の編集</translation>
    </message>
    <message>
        <source>Revert the amplifier settings to those last sent</source>
        <translation>編集を破棄：最後に送信したアンプ設定に戻す</translation>
    </message>
    <message>
        <source>Restores the amplifier settings last sent. Sends nothing.</source>
        <translation>最後に送信したアンプ設定に戻します。何も送信しません。</translation>
    </message>
    <message>
        <source>Clears the fields: no amplifier settings have been sent yet. Sends nothing.</source>
        <translation>欄を空にします。アンプ設定はまだ送信していません。何も送信しません。</translation>
    </message>
    <message>
        <source>Choose what the limit inputs do.</source>
        <translation>リミット入力の動作を選択してください。</translation>
    </message>
    <message>
        <source>A task is running on this module: wait for its end, or cancel it.</source>
        <translation>このモジュールで処理を実行中です。終了を待つか、取り消してください。</translation>
    </message>
</context>
<context>
    <name>nmc::AskDialog</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
</context>
<context>
    <name>nmc::AxesPage</name>
    <message>
        <source>All axes</source>
        <translation>全軸</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>低速</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>高速</translation>
    </message>
    <message>
        <source>Slow jog</source>
        <translation>低速ジョグ</translation>
    </message>
    <message>
        <source>Fast jog</source>
        <translation>高速ジョグ</translation>
    </message>
    <message>
        <source>Step of all axes</source>
        <translation>全軸のステップ</translation>
    </message>
    <message>
        <source>Each axis at its own jog speed.</source>
        <translation>各軸を、それぞれのジョグ速度で動かします。</translation>
    </message>
    <message>
        <source>Each axis at its own max jog speed, set on its Axis or Parameters page.</source>
        <translation>各軸を、それぞれの「軸」または「パラメーター」ページで設定した最高ジョグ速度で動かします。</translation>
    </message>
    <message>
        <source>Distance that one click on Step moves an axis, in its own unit.</source>
        <translation>「ステップ」の1クリックで軸を動かす距離（各軸の単位）です。</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1単位</translation>
    </message>
    <message>
        <source>Enable all</source>
        <translation>全軸オン</translation>
    </message>
    <message>
        <source>Enable all motors</source>
        <translation>全軸オン：全モーター</translation>
    </message>
    <message>
        <source>Home all axes, one after the other</source>
        <translation>全軸原点復帰：1軸ずつ順番に</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>軸の一覧</translation>
    </message>
    <message>
        <source>Homing is not set up for any axis. Set it up on each Homing page.</source>
        <translation>原点復帰が設定された軸がありません。各軸の「原点復帰」ページで設定してください。</translation>
    </message>
    <message>
        <source>All motors are already enabled.</source>
        <translation>すべてのモーターはすでにオンです。</translation>
    </message>
    <message>
        <source>Enables every motor at its present position.</source>
        <translation>すべてのモーターを現在位置でオンにします。</translation>
    </message>
    <message>
        <source>Homes one axis after the other, in the order of the table, with each axis&apos;s homing settings. Any stop ends it.</source>
        <translation>表の順に、各軸の設定に従って1軸ずつ原点復帰を行います。停止操作をすると終了します。</translation>
    </message>
</context>
<context>
    <name>nmc::AxisBox</name>
    <message>
        <source>Name of the axis</source>
        <translation>軸の名前</translation>
    </message>
    <message>
        <source>For example: Z axis</source>
        <translation>例：Z軸</translation>
    </message>
    <message>
        <source>The name of this axis in the list, in messages and in files.</source>
        <translation>一覧、メッセージ、ファイルで使う軸の名前です。</translation>
    </message>
    <message>
        <source>N&amp;ame</source>
        <translation>名前(&amp;A)</translation>
    </message>
    <message>
        <source>Unit of the axis</source>
        <translation>軸の単位</translation>
    </message>
    <message>
        <source>native counts</source>
        <translation>チップのカウント値</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>custom unit</source>
        <translation>独自の単位</translation>
    </message>
    <message>
        <source>The unit for positions and speeds. Changing it keeps every physical value and sends nothing.</source>
        <translation>位置と速度の単位です。変更しても物理量は変わらず、何も送信されません。</translation>
    </message>
    <message>
        <source>Un&amp;it</source>
        <translation>単位(&amp;I)</translation>
    </message>
    <message>
        <source>Counts in 1 unit</source>
        <translation>1単位のカウント数</translation>
    </message>
    <message>
        <source>Counts or steps per unit.</source>
        <translation>1単位あたりのカウント数またはステップ数です。</translation>
    </message>
    <message>
        <source>Symbol of the unit</source>
        <translation>単位の記号</translation>
    </message>
    <message>
        <source>Shown after the numbers, for example µl.</source>
        <translation>数値の後に表示されます。例：µl。</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>記号</translation>
    </message>
    <message>
        <source>Jog is never faster than this.</source>
        <translation>ジョグはこの速度を超えません。</translation>
    </message>
    <message>
        <source>Max &amp;jog speed</source>
        <translation>最高ジョグ速度(&amp;J)</translation>
    </message>
    <message>
        <source>A/D scale, per count</source>
        <translation>A/Dスケール（1カウントあたり）</translation>
    </message>
    <message>
        <source>The value of one A/D count, for example 5 V / 255, or amperes from the amplifier&apos;s current sense.</source>
        <translation>A/D 1カウントの値です。例：5 V / 255、またはアンプの電流検出によるアンペア値。</translation>
    </message>
    <message>
        <source>A/D at &amp;0</source>
        <translation>0のときのA/D値(&amp;0)</translation>
    </message>
    <message>
        <source>Unit of the A/D value</source>
        <translation>A/D値の単位</translation>
    </message>
    <message>
        <source>A, V, or whatever the A/D input measures.</source>
        <translation>A、Vなど、A/D入力で測定する量の単位です。</translation>
    </message>
    <message>
        <source>A/D unit</source>
        <translation>A/D単位</translation>
    </message>
    <message>
        <source>%1 in 1 %2</source>
        <translation>%1 / 1 %2</translation>
    </message>
    <message>
        <source>Calculate…</source>
        <translation>計算…</translation>
    </message>
    <message>
        <source>Calculate the unit from encoder, gear and screw</source>
        <translation>計算：エンコーダー、ギア、ねじから単位を計算</translation>
    </message>
    <message>
        <source>Calculates the unit from the data of encoder, gear and screw. Sends nothing.</source>
        <translation>エンコーダー、ギア、ねじのデータから単位を計算します。何も送信しません。</translation>
    </message>
    <message>
        <source>reversed: forward counts down</source>
        <translation>反転：正方向でカウントが減る</translation>
    </message>
    <message>
        <source>Reverses positions, directions and travel limits of this axis on the screen. Sends nothing.</source>
        <translation>この軸の位置、方向、移動範囲の表示を反転します。何も送信しません。</translation>
    </message>
    <message>
        <source>Axis %1 has the same name, so programs can call neither by it.</source>
        <translation>軸%1が同じ名前なので、プログラムはどちらもこの名前では指定できません。</translation>
    </message>
</context>
<context>
    <name>nmc::AxisRow</name>
    <message>
        <source>State of %1</source>
        <translation>%1の状態</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>%1の位置</translation>
    </message>
    <message>
        <source>Hold to move %1 in reverse</source>
        <translation>◂ ジョグ：押している間、%1を逆方向に移動</translation>
    </message>
    <message>
        <source>Hold to move %1 forward</source>
        <translation>ジョグ ▸：押している間、%1を正方向に移動</translation>
    </message>
    <message>
        <source>Step %1 in reverse</source>
        <translation>◂| ステップ：%1を逆方向に1ステップ移動</translation>
    </message>
    <message>
        <source>Step %1 forward</source>
        <translation>ステップ |▸：%1を正方向に1ステップ移動</translation>
    </message>
    <message>
        <source>Home earlier</source>
        <translation>順番を前へ</translation>
    </message>
    <message>
        <source>Home %1 one place earlier</source>
        <translation>順番を前へ：%1の原点復帰の順番を1つ前へ</translation>
    </message>
    <message>
        <source>This step is less than one count of this axis, or beyond its range. Choose another step.</source>
        <translation>このステップはこの軸の1カウント未満か、範囲外です。別のステップを選択してください。</translation>
    </message>
    <message>
        <source>Moves forward by the step above, then holds.</source>
        <translation>上のステップだけ正方向に動き、保持します。</translation>
    </message>
    <message>
        <source>Moves in reverse by the step above, then holds.</source>
        <translation>上のステップだけ逆方向に動き、保持します。</translation>
    </message>
    <message>
        <source>Homing is not set up for this axis. Set it up on its Homing page.</source>
        <translation>この軸の原点復帰が設定されていません。「原点復帰」ページで設定してください。</translation>
    </message>
    <message>
        <source>Home all starts with this axis.</source>
        <translation>全軸原点復帰はこの軸から始まります。</translation>
    </message>
    <message>
        <source>Home all homes this axis as number %1. Click to move it one place earlier. Nothing moves.</source>
        <translation>全軸原点復帰では、この軸は%1番目です。クリックすると1つ前になります。何も動きません。</translation>
    </message>
    <message>
        <source>Home: %1.</source>
        <translation>原点：%1。</translation>
    </message>
    <message>
        <source>Home: –</source>
        <translation>原点：–</translation>
    </message>
</context>
<context>
    <name>nmc::Banner</name>
    <message>
        <source>Important message</source>
        <translation>重要なメッセージ</translation>
    </message>
    <message>
        <source>Hides this message here. It stays in the message list.</source>
        <translation>ここではこのメッセージを隠します。メッセージ一覧には残ります。</translation>
    </message>
    <message>
        <source>Hide this message</source>
        <translation>このメッセージを隠す</translation>
    </message>
    <message>
        <source>Shows the full text and all other messages in the message list.</source>
        <translation>メッセージ一覧に全文とほかのすべてのメッセージを表示します。</translation>
    </message>
    <message>
        <source>%1 more…</source>
        <translation>ほか%1件…</translation>
    </message>
    <message>
        <source>Read all…</source>
        <translation>すべて読む…</translation>
    </message>
</context>
<context>
    <name>nmc::Bell</name>
    <message>
        <source>Plays a sound on each fault, and when a search for home, a test, a series of steps or a sequence ends.</source>
        <translation>異常が起きたとき、および原点復帰、テスト、連続ステップ、シーケンスが終わったときに音を鳴らします。</translation>
    </message>
    <message>
        <source>So&amp;unds</source>
        <translation>サウンド(&amp;U)</translation>
    </message>
</context>
<context>
    <name>nmc::BenchTruth</name>
    <message>
        <source>Simulator values of the module</source>
        <translation>モジュールのシミュレーター値</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>シャフト</translation>
    </message>
    <message>
        <source>The true position of the shaft since the simulation started.</source>
        <translation>シミュレーション開始時からのシャフトの真の位置です。</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>位置カウンター</translation>
    </message>
    <message>
        <source>The position as the module counts it.</source>
        <translation>モジュールが数えている位置です。</translation>
    </message>
    <message>
        <source>True, not calculated.</source>
        <translation>計算値ではなく真値です。</translation>
    </message>
    <message>
        <source>Of the shaft.</source>
        <translation>シャフトの速度です。</translation>
    </message>
    <message>
        <source>Step rate</source>
        <translation>ステップレート</translation>
    </message>
    <message>
        <source>Negative in reverse.</source>
        <translation>逆方向では負です。</translation>
    </message>
    <message>
        <source>The sign is the direction.</source>
        <translation>符号は方向です。</translation>
    </message>
    <message>
        <source>255 is full current.</source>
        <translation>255が最大電流です。</translation>
    </message>
    <message>
        <source>A/D reads</source>
        <translation>A/D読み取り値</translation>
    </message>
    <message>
        <source>Violations</source>
        <translation>違反</translation>
    </message>
    <message>
        <source>Protocol violations that would upset a real module.</source>
        <translation>実際のモジュールなら誤動作するプロトコル違反です。</translation>
    </message>
    <message>
        <source>%1 s, module %2: %3, %4</source>
        <translation>%1 s、モジュール%2：%3、%4</translation>
    </message>
</context>
<context>
    <name>nmc::BodePlot</name>
    <message>
        <source>No measurement yet. The motor follows sine waves from slow to fast, which shows the response of the loop.</source>
        <translation>まだ測定していません。モーターが低い周波数から高い周波数まで正弦波に追従し、ループの応答が分かります。</translation>
    </message>
    <message>
        <source>Magnitude, dB</source>
        <translation>ゲイン、dB</translation>
    </message>
    <message>
        <source>Phase, degrees</source>
        <translation>位相、度</translation>
    </message>
    <message>
        <source>T, closed loop</source>
        <translation>T、閉ループ</translation>
    </message>
    <message>
        <source>L, open loop</source>
        <translation>L、開ループ</translation>
    </message>
    <message>
        <source>T: closed loop, from command to position. L: open loop; its phase above -180° where it crosses 0 dB is the phase margin. Right of the grey line the baud rate is too low to measure. Bars: two standard deviations of T.</source>
        <translation>T：閉ループ、指令から位置まで。L：開ループ。0 dBを横切る点での-180°からの位相が位相余裕です。灰色の線より右は、ボーレートが低すぎて測定できません。バー：Tの標準偏差の2倍。</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>周波数、Hz</translation>
    </message>
</context>
<context>
    <name>nmc::ChainDialog</name>
    <message>
        <source>Doctor, groups and baud rate</source>
        <translation>診断、グループ、ボーレート</translation>
    </message>
    <message>
        <source>Doctor</source>
        <translation>診断</translation>
    </message>
</context>
<context>
    <name>nmc::ChainMenu</name>
    <message>
        <source>Chain &amp;doctor…</source>
        <translation>チェーン診断(&amp;D)…</translation>
    </message>
    <message>
        <source>Compares the expected modules with those found, and shows where the chain probably breaks.</source>
        <translation>想定モジュールと検出モジュールを比較し、チェーンが切れていると思われる場所を示します。</translation>
    </message>
    <message>
        <source>&amp;Groups…</source>
        <translation>グループ(&amp;G)…</translation>
    </message>
    <message>
        <source>Assigns modules to groups, and starts their loaded moves together.</source>
        <translation>モジュールをグループに割り当て、ロード済みの移動を一斉に開始します。</translation>
    </message>
    <message>
        <source>B&amp;aud rate of the chain…</source>
        <translation>チェーンのボーレート(&amp;A)…</translation>
    </message>
    <message>
        <source>Changes the baud rate of the whole chain.</source>
        <translation>チェーン全体のボーレートを変更します。</translation>
    </message>
    <message>
        <source>Scans the chain again; nothing is reset.</source>
        <translation>チェーンを再スキャンします。何もリセットされません。</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost…</source>
        <translation>ネットワークを再起動：位置とゲインは失われます(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Let programs in</source>
        <translation>プログラムの接続を許可(&amp;L)</translation>
    </message>
    <message>
        <source>Other programs on this computer may read the chain, and ask to move motors.</source>
        <translation>このコンピューターの他のプログラムがチェーンを読み取り、モーターの操作を求めることができます。</translation>
    </message>
    <message>
        <source>L&amp;end the line to a program…</source>
        <translation>プログラムに回線を貸す(&amp;E)…</translation>
    </message>
    <message>
        <source>A program has the modules for itself; the panel shows what they report.</source>
        <translation>プログラムがモジュールを占有し、パネルはその報告を表示します。</translation>
    </message>
    <message>
        <source>&amp;Copy settings to other axes…</source>
        <translation>設定をほかの軸にコピー(&amp;C)…</translation>
    </message>
    <message>
        <source>Copies gains, limits and other settings to axes of the same type. Shows the differences first.</source>
        <translation>ゲイン、リミットなどの設定を同じ種類の軸にコピーします。先に相違点を表示します。</translation>
    </message>
</context>
<context>
    <name>nmc::ChainModel</name>
    <message>
        <source>PC</source>
        <translation>PC</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1, %2, at address %3 on the wire</source>
        <translation>%1、%2、回線上のアドレス%3</translation>
    </message>
    <message>
        <source>%1 · looking for modules…</source>
        <translation>%1 · モジュールを検索中…</translation>
    </message>
    <message>
        <source>%1, address %2, %3, %4</source>
        <translation>%1、アドレス%2、%3、%4</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>%1, position %2</source>
        <translation>%1、位置%2</translation>
    </message>
</context>
<context>
    <name>nmc::ChainView</name>
    <message>
        <source>Modules in wire order, the farthest from the PC first</source>
        <translation>配線順のモジュール（PCから最も遠いものが先頭）</translation>
    </message>
    <message>
        <source>Not connected.

Choose a port above and connect. Without hardware, choose the simulator.</source>
        <translation>未接続。

上でポートを選択して接続してください。ハードウェアがない場合は、シミュレーターを選択してください。</translation>
    </message>
</context>
<context>
    <name>nmc::ColourChoice</name>
    <message>
        <source>&amp;System</source>
        <translation>システム(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>ハイコントラスト(&amp;H)</translation>
    </message>
</context>
<context>
    <name>nmc::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>コマンドを検索</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>コマンドの検索</translation>
    </message>
    <message>
        <source>Type what to do, for example: go home</source>
        <translation>したいことを入力（例：原点へ移動）</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>What it does, or why it is unavailable</source>
        <translation>動作、または使用できない理由</translation>
    </message>
    <message>
        <source>No matching command.</source>
        <translation>該当するコマンドがありません。</translation>
    </message>
    <message>
        <source>Not possible now.</source>
        <translation>今は実行できません。</translation>
    </message>
    <message>
        <source>Press Enter to run it.</source>
        <translation>Enterで実行します。</translation>
    </message>
    <message>
        <source>Its module is no longer connected.</source>
        <translation>対象のモジュールは接続されていません。</translation>
    </message>
    <message>
        <source>Press Enter to show it on the module&apos;s page. Nothing is sent.</source>
        <translation>Enterで、モジュールのページに表示します。何も送信しません。</translation>
    </message>
</context>
<context>
    <name>nmc::ConnectionBar</name>
    <message>
        <source>&amp;Connect</source>
        <translation>接続(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>切断(&amp;D)</translation>
    </message>
    <message>
        <source>Connection and stop</source>
        <translation>接続と停止</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>ポート</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>The serial port of the modules, or the simulator.</source>
        <translation>モジュールのシリアルポート、またはシミュレーターです。</translation>
    </message>
    <message>
        <source>The baud rate for a chain without addresses; a chain that has them keeps its rate.</source>
        <translation>アドレスのないチェーンに使うボーレートです。アドレスのあるチェーンは、元のボーレートのままです。</translation>
    </message>
    <message>
        <source>Por&amp;t</source>
        <translation>ポート(&amp;T)</translation>
    </message>
    <message>
        <source>Bd</source>
        <translation>Bd</translation>
    </message>
    <message>
        <source>not listed</source>
        <translation>一覧にありません</translation>
    </message>
    <message>
        <source>no hardware needed</source>
        <translation>ハードウェア不要</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
    <message>
        <source>Disconnect first.</source>
        <translation>先に切断してください。</translation>
    </message>
    <message>
        <source>No port is open.</source>
        <translation>開いているポートがありません。</translation>
    </message>
    <message>
        <source>Closes the port.</source>
        <translation>ポートを閉じます。</translation>
    </message>
    <message>
        <source>Connect read-&amp;only</source>
        <translation>読み取り専用で接続(&amp;O)</translation>
    </message>
    <message>
        <source>Other ways to connect</source>
        <translation>ほかの接続方法</translation>
    </message>
    <message>
        <source>Other ways to connect.</source>
        <translation>ほかの接続方法です。</translation>
    </message>
    <message>
        <source>Opens the port and only reads: only status requests are sent. STOP ALL still works.</source>
        <translation>ポートを開いて読み取りだけを行います。ステータス要求だけを送信します。全停止は使用できます。</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>ボー</translation>
    </message>
</context>
<context>
    <name>nmc::ControlLineBox</name>
    <message>
        <source>Control line</source>
        <translation>制御行</translation>
    </message>
    <message>
        <source>Type an nmcsim command, then press Enter: state, set, power-cycle, break, mend, stats, time, fault. Shortcut: Ctrl+L.</source>
        <translation>nmcsimのコマンドを入力してEnterを押します：state、set、power-cycle、break、mend、stats、time、fault。ショートカット：Ctrl+L。</translation>
    </message>
    <message>
        <source>The simulator&apos;s answer</source>
        <translation>シミュレーターの応答</translation>
    </message>
</context>
<context>
    <name>nmc::CopyDialog</name>
    <message>
        <source>Axis to copy from</source>
        <translation>コピー元の軸</translation>
    </message>
    <message>
        <source>The axis whose settings are copied.</source>
        <translation>設定のコピー元になる軸です。</translation>
    </message>
    <message>
        <source>&amp;Show differences</source>
        <translation>相違点を表示(&amp;S)</translation>
    </message>
    <message>
        <source>Copy settings to other axes</source>
        <translation>設定をほかの軸にコピー</translation>
    </message>
    <message>
        <source>Axes to copy to</source>
        <translation>コピー先の軸</translation>
    </message>
    <message>
        <source>Axes with the same type of module and other settings.</source>
        <translation>モジュールの種類が同じで設定が異なる軸です。</translation>
    </message>
    <message>
        <source>Settings to copy</source>
        <translation>コピーする設定</translation>
    </message>
    <message>
        <source>Settings in which at least one of these axes differs.</source>
        <translation>これらの軸の少なくとも 1 つで異なる設定です。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>The differences are shown before anything is changed or sent. Numbers are copied in the units of the module: counts or steps.</source>
        <translation>変更や送信の前に相違点を表示します。数値はモジュールの単位 (カウントまたはステップ) でコピーします。</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>コピー先(&amp;T)</translation>
    </message>
    <message>
        <source>S&amp;ettings</source>
        <translation>設定(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>コピー元(&amp;F)</translation>
    </message>
    <message>
        <source>No other axis with this type of module has other settings.</source>
        <translation>この種類のモジュールで設定が異なる軸はほかにありません。</translation>
    </message>
    <message>
        <source>Select the axes to copy to.</source>
        <translation>コピー先の軸を選択してください。</translation>
    </message>
    <message>
        <source>Select the settings to copy.</source>
        <translation>コピーする設定を選択してください。</translation>
    </message>
    <message>
        <source>These settings are the same already.</source>
        <translation>これらの設定はすでに同じです。</translation>
    </message>
    <message>
        <source>Shows what would change. Nothing is sent.</source>
        <translation>変更される内容を表示します。何も送信しません。</translation>
    </message>
</context>
<context>
    <name>nmc::CounterBox</name>
    <message>
        <source>Set and restart</source>
        <translation>設定して0から</translation>
    </message>
    <message>
        <source>Set and restart the timer or counter</source>
        <translation>設定して0から：タイマーまたはカウンター</translation>
    </message>
    <message>
        <source>Latch inputs</source>
        <translation>入力をラッチ</translation>
    </message>
    <message>
        <source>Latch inputs and counter at the same time</source>
        <translation>入力をラッチ：カウンターも同時に</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>格納</translation>
    </message>
    <message>
        <source>Store outputs for later</source>
        <translation>格納：後で出力する値</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>一斉出力</translation>
    </message>
    <message>
        <source>Apply the stored outputs</source>
        <translation>一斉出力：格納した出力</translation>
    </message>
    <message>
        <source>Counter and synchronous I/O</source>
        <translation>カウンターと同期I/O</translation>
    </message>
    <message>
        <source>Counter source</source>
        <translation>カウンターの入力源</translation>
    </message>
    <message>
        <source>timer, 5 MHz</source>
        <translation>タイマー、5 MHz</translation>
    </message>
    <message>
        <source>counter of rising edges on IO10</source>
        <translation>IO10の立ち上がりエッジのカウンター</translation>
    </message>
    <message>
        <source>Prescaler</source>
        <translation>プリスケーラー</translation>
    </message>
    <message>
        <source>every edge</source>
        <translation>すべてのエッジ</translation>
    </message>
    <message>
        <source>every 2nd edge</source>
        <translation>2エッジごと</translation>
    </message>
    <message>
        <source>every 4th edge</source>
        <translation>4エッジごと</translation>
    </message>
    <message>
        <source>every 8th edge</source>
        <translation>8エッジごと</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>カウント</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>カウント対象</translation>
    </message>
    <message>
        <source>Latched values</source>
        <translation>ラッチした値</translation>
    </message>
    <message>
        <source>Latched</source>
        <translation>ラッチ値</translation>
    </message>
    <message>
        <source>Outputs to store</source>
        <translation>格納する出力</translation>
    </message>
    <message>
        <source>Add up the outputs: IO1 is 1, IO2 is 2, IO3 is 4, up to IO12, which is 2048.</source>
        <translation>出力の値を合計します：IO1は1、IO2は2、IO3は4、…、IO12は2048です。</translation>
    </message>
    <message>
        <source>%1 to store</source>
        <translation>%1の格納値</translation>
    </message>
    <message>
        <source>Counter source unknown: another program has set it.</source>
        <translation>カウンターの入力源が不明です。別のプログラムが設定しました。</translation>
    </message>
    <message>
        <source>= %1 s</source>
        <translation>= %1 s</translation>
    </message>
    <message>
        <source>%1 Hz on IO10</source>
        <translation>%1 Hz（IO10）</translation>
    </message>
    <message>
        <source>IO12 to IO1: %1, count %2</source>
        <translation>IO12～IO1：%1、カウント%2</translation>
    </message>
    <message>
        <source>Sends the settings above. The count restarts at 0.</source>
        <translation>上の設定を送信します。カウントは0から始まります。</translation>
    </message>
    <message>
        <source>Latches all pins and the count at the same moment, and reads them.</source>
        <translation>全ピンとカウントを同時にラッチして読み取ります。</translation>
    </message>
    <message>
        <source>Sends these values to the module, which keeps them until you apply them.</source>
        <translation>この値をモジュールに送信します。一斉出力するまでモジュールが保持します。</translation>
    </message>
    <message>
        <source>Store outputs first.</source>
        <translation>先に出力を格納してください。</translation>
    </message>
    <message>
        <source>Applies the stored pin levels and PWM values at the same moment.</source>
        <translation>格納したピンとPWM値を同時に出力します。</translation>
    </message>
    <message>
        <source>stored: %1, PWM %2 and %3</source>
        <translation>格納済み：%1、PWM %2と%3</translation>
    </message>
</context>
<context>
    <name>nmc::CounterTable</name>
    <message>
        <source>Counters of the link</source>
        <translation>通信のカウンター</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>カウント</translation>
    </message>
    <message>
        <source>Since the chain was found</source>
        <translation>チェーン検出以降</translation>
    </message>
    <message>
        <source>sent: commands that asked for an answer</source>
        <translation>送信：応答を求めたコマンド</translation>
    </message>
    <message>
        <source>accepted: answers that passed all checks</source>
        <translation>受理：すべての検査に合格した応答</translation>
    </message>
    <message>
        <source>mean round trip, from sending a command to its complete answer</source>
        <translation>平均往復時間：コマンドの送信から応答の完了まで</translation>
    </message>
    <message>
        <source>longest round trip</source>
        <translation>最長往復時間</translation>
    </message>
    <message>
        <source>retried: commands that were sent again</source>
        <translation>再試行：再送信したコマンド</translation>
    </message>
    <message>
        <source>timeouts: no answer, or too few bytes</source>
        <translation>タイムアウト：応答なし、またはバイト不足</translation>
    </message>
    <message>
        <source>refused by the module: the command reached it with a wrong checksum</source>
        <translation>モジュールが拒否：コマンドが誤ったチェックサムで届いた</translation>
    </message>
    <message>
        <source>wrong checksums: the answer was corrupted in transit</source>
        <translation>チェックサム不一致：応答が途中で壊れた</translation>
    </message>
    <message>
        <source>surplus bytes: received without a request</source>
        <translation>余分なバイト：要求なしに受信</translation>
    </message>
    <message>
        <source>of these, stale: late answers, discarded</source>
        <translation>うち期限切れ：遅れて届き破棄した応答</translation>
    </message>
    <message>
        <source>resyncs: link checked again after errors</source>
        <translation>再同期：エラー後の通信の再確認</translation>
    </message>
    <message>
        <source>rejected by a rule: checksum right, but answer implausible</source>
        <translation>規則による棄却：チェックサムは正しいが、あり得ない応答</translation>
    </message>
    <message>
        <source>  of these: %1</source>
        <translation>  うち：%1</translation>
    </message>
</context>
<context>
    <name>nmc::CursorPanel</name>
    <message>
        <source>Shows or hides the cursor readings.</source>
        <translation>カーソル値の表示を切り替えます。</translation>
    </message>
    <message>
        <source>Between the cursors: %1</source>
        <translation>カーソル間：%1</translation>
    </message>
    <message>
        <source>Spectrum…</source>
        <translation>スペクトル…</translation>
    </message>
    <message>
        <source>Shows at which frequencies a signal oscillates between the cursors.</source>
        <translation>カーソル間で信号が振動している周波数を表示します。</translation>
    </message>
    <message>
        <source>XY view…</source>
        <translation>XY表示…</translation>
    </message>
    <message>
        <source>Shows one signal over another between the cursors.</source>
        <translation>カーソル間で、ある信号を別の信号に対して表示します。</translation>
    </message>
</context>
<context>
    <name>nmc::CursorTable</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>ピークツーピーク</translation>
    </message>
    <message>
        <source>Slope, per s</source>
        <translation>傾き（1 sあたり）</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>周波数</translation>
    </message>
    <message>
        <source> (%1 Hz)</source>
        <translation> (%1 Hz)</translation>
    </message>
</context>
<context>
    <name>nmc::DetailsBox</name>
    <message>
        <source>The move has ended; in velocity mode the goal velocity is reached.</source>
        <translation>移動が終了しました。速度モードでは目標速度に達しています。</translation>
    </message>
    <message>
        <source>The current limit was reached. Stays set until you clear the sticky bits.</source>
        <translation>電流制限に達しました。スティッキービットをクリアするまでセットされたままです。</translation>
    </message>
    <message>
        <source>Motor power is present.</source>
        <translation>モーター電源があります。</translation>
    </message>
    <message>
        <source>The position error exceeded its limit, or the servo is off. Stays set until you clear the sticky bits.</source>
        <translation>位置偏差が上限を超えたか、サーボがオフです。スティッキービットをクリアするまでセットされたままです。</translation>
    </message>
    <message>
        <source>The complement of the encoder&apos;s index.</source>
        <translation>エンコーダーのインデックスの反転信号です。</translation>
    </message>
    <message>
        <source>The 32-bit position has wrapped. Stays set until you clear the sticky bits.</source>
        <translation>32ビットの位置が桁あふれしました。スティッキービットをクリアするまでセットされたままです。</translation>
    </message>
    <message>
        <source>The servo is on.</source>
        <translation>サーボがオンです。</translation>
    </message>
    <message>
        <source>The first acceleration phase of the move has ended.</source>
        <translation>移動の最初の加速が終わりました。</translation>
    </message>
    <message>
        <source>The constant phase of the move has ended.</source>
        <translation>移動の定速区間が終わりました。</translation>
    </message>
    <message>
        <source>A servo tick took too long; typically not serious. Stays set until you clear the sticky bits.</source>
        <translation>サーボ周期の処理が時間を超えました。通常は問題ありません。スティッキービットをクリアするまでセットされたままです。</translation>
    </message>
    <message>
        <source>Clear stic&amp;ky bits</source>
        <translation>スティッキービットをクリア(&amp;K)</translation>
    </message>
    <message>
        <source>Clear sticky bits of the status</source>
        <translation>スティッキービットをクリア：ステータスのビット</translation>
    </message>
    <message>
        <source>Auxiliary byte</source>
        <translation>補助バイト</translation>
    </message>
    <message>
        <source>A/D (motor current)</source>
        <translation>A/D（モーター電流）</translation>
    </message>
    <message>
        <source>Velocity reported by the chip</source>
        <translation>チップが報告する速度</translation>
    </message>
    <message>
        <source>, auxiliary %1</source>
        <translation>、補助%1</translation>
    </message>
    <message>
        <source>Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing.</source>
        <translation>overcurrent、pos_error、pos_wrap、servo_overrunをクリアします。何も始動しません。</translation>
    </message>
    <message>
        <source>Position error reported by the chip</source>
        <translation>チップが報告する位置偏差</translation>
    </message>
    <message>
        <source>Path points left</source>
        <translation>残りのパス点数</translation>
    </message>
    <message>
        <source>The module is sending step pulses.</source>
        <translation>ステップパルスが出力されています。</translation>
    </message>
    <message>
        <source>The driver is enabled (AMP_EN is high).</source>
        <translation>ドライバーが有効です（AMP_ENがHigh）。</translation>
    </message>
    <message>
        <source>Motor power is present (PWR_SENSE is high).</source>
        <translation>モーター電源があります（PWR_SENSEがHigh）。</translation>
    </message>
    <message>
        <source>The motor has reached its commanded speed.</source>
        <translation>モーターが指令速度に達しています。</translation>
    </message>
    <message>
        <source>Runs with a ramp: velocity profile mode.</source>
        <translation>加減速のある運転：速度プロファイルモード。</translation>
    </message>
    <message>
        <source>Moves to a position with a ramp: trapezoidal profile mode.</source>
        <translation>加減速のある位置への移動：台形プロファイルモード。</translation>
    </message>
    <message>
        <source>High stops the motor, unless it is ignored.</source>
        <translation>無視されていなければ、Highでモーターが停止します。</translation>
    </message>
    <message>
        <source>General purpose input.</source>
        <translation>汎用入力です。</translation>
    </message>
    <message>
        <source>For homing.</source>
        <translation>原点復帰用です。</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>trapezoidal profile</source>
        <translation>台形プロファイル</translation>
    </message>
    <message>
        <source>velocity profile</source>
        <translation>速度プロファイル</translation>
    </message>
    <message>
        <source>unprofiled, with stop</source>
        <translation>プロファイルなし、停止あり</translation>
    </message>
    <message>
        <source>unprofiled, without stop</source>
        <translation>プロファイルなし、停止なし</translation>
    </message>
    <message>
        <source>moving, commanded by another program</source>
        <translation>別のプログラムの指令で動作中</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>現在位置を0に(&amp;Z)</translation>
    </message>
    <message>
        <source>Inputs byte</source>
        <translation>入力バイト</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Timer count</source>
        <translation>タイマー値</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>, inputs %1</source>
        <translation>、入力%1</translation>
    </message>
    <message>
        <source>High blocks counting up, unless it is ignored.</source>
        <translation>無視されていなければ、Highでカウントの増える方向を禁止します。</translation>
    </message>
    <message>
        <source>High blocks counting down, unless it is ignored.</source>
        <translation>無視されていなければ、Highでカウントの減る方向を禁止します。</translation>
    </message>
</context>
<context>
    <name>nmc::DifferencesDialog</name>
    <message>
        <source>&amp;Select all</source>
        <translation>すべて選択(&amp;S)</translation>
    </message>
    <message>
        <source>Clear a&amp;ll</source>
        <translation>すべて解除(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>適用(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>ファイルの値</translation>
    </message>
    <message>
        <source>Here or last sent</source>
        <translation>現在値/最終送信値</translation>
    </message>
    <message>
        <source>When applied</source>
        <translation>適用したとき</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>すべて選択</translation>
    </message>
    <message>
        <source>Selects all check boxes, including settings sent to modules that are on.</source>
        <translation>オンのモジュールに送信する設定も含め、すべてのチェックボックスを選択します。</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>すべて解除</translation>
    </message>
    <message>
        <source>Clears all check boxes.</source>
        <translation>すべてのチェックボックスを外します。</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Keeps everything as it is.</source>
        <translation>すべて現在のままにします。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; differs from the current settings. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced by those in the file.</source>
        <translation>「%1」は現在の設定と異なります。「適用」を選択するまで、変更も送信も行われず、モーターも動きません。入力済みで未送信の値は、ファイルの値に置き換わります。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1個の値</translation>
    </message>
    <message>
        <source>Applies the selected settings and sends those marked as sent.</source>
        <translation>選択した設定を適用し、「モジュールに送信されます」と示されたものを送信します。</translation>
    </message>
    <message>
        <source>Selected: %1 of %2. Sent to modules: %3.</source>
        <translation>選択：%2件中%1件。モジュールに送信：%3件。</translation>
    </message>
    <message>
        <source>Differences from the present settings</source>
        <translation>現在の設定との相違点</translation>
    </message>
    <message>
        <source>Settings of %1 for other axes. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced.</source>
        <translation>ほかの軸のための %1 の設定です。「適用」を選ぶまで何も変更も送信もされず、モーターも動きません。入力済みで未送信の値は置き換えられます。</translation>
    </message>
    <message>
        <source>Copy settings</source>
        <translation>設定のコピー</translation>
    </message>
    <message>
        <source>%1: differences</source>
        <translation>%1: 相違点</translation>
    </message>
</context>
<context>
    <name>nmc::DirectBox</name>
    <message>
        <source>%1 as set here</source>
        <translation>%1：この設定で</translation>
    </message>
    <message>
        <source>What the chip will do</source>
        <translation>チップの動作</translation>
    </message>
    <message>
        <source>Command bytes</source>
        <translation>コマンドのバイト列</translation>
    </message>
    <message>
        <source>A bit of %1: %2</source>
        <translation>%1のビット：%2</translation>
    </message>
    <message>
        <source>Bits of %1: %2</source>
        <translation>%1のビット：%2</translation>
    </message>
    <message>
        <source>Data of %1: %2</source>
        <translation>%1のデータ：%2</translation>
    </message>
    <message>
        <source>%1: load</source>
        <translation>%1：ロード</translation>
    </message>
    <message>
        <source>If cleared, the chip keeps the previously loaded value.</source>
        <translation>チェックを外すと、チップは以前にロードした値を保ちます。</translation>
    </message>
</context>
<context>
    <name>nmc::DirectionCheckBox</name>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Direction check…</source>
        <translation>方向チェック…</translation>
    </message>
    <message>
        <source>Direction of motor and encoder</source>
        <translation>モーターとエンコーダーの方向</translation>
    </message>
    <message>
        <source>Direction check of motor and encoder</source>
        <translation>方向チェック：モーターとエンコーダー</translation>
    </message>
    <message>
        <source>Cancel the direction check</source>
        <translation>方向チェックを中止</translation>
    </message>
    <message>
        <source>Result of the direction check</source>
        <translation>方向チェックの結果</translation>
    </message>
    <message>
        <source>A direction check is running.</source>
        <translation>方向チェックの実行中です。</translation>
    </message>
    <message>
        <source>Something turns the motor. Wait until it is at rest.</source>
        <translation>何かがモーターを回しています。静止するまで待ってください。</translation>
    </message>
    <message>
        <source>The motor of %1 will move a little, forward and in reverse. It is driven in pulses of less than 0.1 s, with slowly rising power up to %2 % of its supply, until it has moved %3. A motor that runs freely may coast farther; more than %4 ends the check. Keep clear of it.</source>
        <translation>%1のモーターが正方向と逆方向に少し動きます。1回0.1秒未満の駆動を、電源の%2%まで少しずつ強めながら、%3動くまで繰り返します。自由に回るモーターは、さらに惰走することがあります。%4を超えるとチェックを終了します。モーターに近づかないでください。</translation>
    </message>
    <message>
        <source>Direction check</source>
        <translation>方向チェック</translation>
    </message>
    <message>
        <source>&amp;Pulse motor</source>
        <translation>モーターを駆動(&amp;P)</translation>
    </message>
    <message>
        <source>Driving it in reverse.</source>
        <translation>逆方向に駆動しています。</translation>
    </message>
    <message>
        <source>Driving it forward.</source>
        <translation>正方向に駆動しています。</translation>
    </message>
    <message>
        <source>Inconclusive: see the message.</source>
        <translation>判定不能：メッセージを参照してください。</translation>
    </message>
    <message>
        <source>Not checked in this connection. Run the check before you enable the servo for the first time: with motor or encoder reversed, it runs away.</source>
        <translation>この接続では未チェックです。初めてサーボをオンにする前にチェックしてください。モーターまたはエンコーダーが逆だと暴走します。</translation>
    </message>
    <message>
        <source>Moves the motor a little, without the servo, to check that it turns the way its encoder counts. Asks first.</source>
        <translation>サーボを使わずにモーターを少し動かし、エンコーダーの数える方向に回るかをチェックします。実行前に確認します。</translation>
    </message>
    <message>
        <source>No direction check is running.</source>
        <translation>方向チェックは実行していません。</translation>
    </message>
    <message>
        <source>Ends the check and switches the motor off.</source>
        <translation>チェックを終了し、モーターをオフにします。</translation>
    </message>
</context>
<context>
    <name>nmc::DoctorPage</name>
    <message>
        <source>Chain doctor</source>
        <translation>チェーン診断</translation>
    </message>
    <message>
        <source>Modules expected and found, the farthest from the PC first</source>
        <translation>想定モジュールと検出モジュール（PCから最も遠いものが先頭）</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>想定</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>検出</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Scan again: look for modules</source>
        <translation>再スキャン：モジュールを検索</translation>
    </message>
    <message>
        <source>Accep&amp;t as found</source>
        <translation>検出結果を採用(&amp;T)</translation>
    </message>
    <message>
        <source>Accept as found</source>
        <translation>検出結果を採用</translation>
    </message>
    <message>
        <source>&amp;Restart the network…</source>
        <translation>ネットワークを再起動(&amp;R)…</translation>
    </message>
    <message>
        <source>Restart the network: positions and gains are lost</source>
        <translation>ネットワークを再起動：位置とゲインは失われます</translation>
    </message>
    <message>
        <source>Scans the chain again with status requests only: nothing is reset, nothing moves.</source>
        <translation>ステータス要求だけでチェーンを再スキャンします。何もリセットされず、何も動きません。</translation>
    </message>
    <message>
        <source>The chain already matches.</source>
        <translation>チェーンはすでに一致しています。</translation>
    </message>
    <message>
        <source>From now on, the panel expects the modules found here.</source>
        <translation>以後、パネルはここで検出したモジュールを想定します。</translation>
    </message>
</context>
<context>
    <name>nmc::ExpertBox</name>
    <message>
        <source>Capture only</source>
        <translation>取り込みのみ</translation>
    </message>
    <message>
        <source>Stop abruptly</source>
        <translation>即停止</translation>
    </message>
    <message>
        <source>Stop smoothly</source>
        <translation>減速停止</translation>
    </message>
    <message>
        <source>The chip stops watching for home.</source>
        <translation>チップが原点の監視をやめます。</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register and stops. Start the motion with a command of your own.</source>
        <translation>これらの事象のうち最初のもので、チップは位置を原点レジスターに格納して停止します。動作は別のコマンドで開始してください。</translation>
    </message>
    <message>
        <source>At the first of these events the chip stores its position in the home register. The motion goes on.</source>
        <translation>これらの事象のうち最初のもので、チップは位置を原点レジスターに格納します。動作は続きます。</translation>
    </message>
    <message>
        <source>Load Trajectory</source>
        <translation>Load Trajectory</translation>
    </message>
    <message>
        <source>Send load</source>
        <translation>ロードを送信</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Trapezoidal</source>
        <translation>台形</translation>
    </message>
    <message>
        <source>Position (counts)</source>
        <translation>位置（カウント）</translation>
    </message>
    <message>
        <source>Velocity (counts/tick × 65536)</source>
        <translation>速度（カウント/周期 × 65536）</translation>
    </message>
    <message>
        <source>Acceleration (counts/tick² × 65536)</source>
        <translation>加速度（カウント/周期² × 65536）</translation>
    </message>
    <message>
        <source>Reverse (velocity and PWM)</source>
        <translation>逆方向（速度とPWM）</translation>
    </message>
    <message>
        <source>Start motion now</source>
        <translation>直ちに動作を開始</translation>
    </message>
    <message>
        <source>Stop Motor</source>
        <translation>Stop Motor</translation>
    </message>
    <message>
        <source>Send stop</source>
        <translation>停止を送信</translation>
    </message>
    <message>
        <source>Amplifier only</source>
        <translation>アンプのみ</translation>
    </message>
    <message>
        <source>At a position</source>
        <translation>指定位置</translation>
    </message>
    <message>
        <source>Amplifier enabled</source>
        <translation>アンプ有効</translation>
    </message>
    <message>
        <source>Switches only AMP_EN. The servo stays as it is.</source>
        <translation>AMP_ENだけを切り替えます。サーボはそのままです。</translation>
    </message>
    <message>
        <source>The servo is switched off. The motor is free to turn.</source>
        <translation>サーボをオフにします。モーターは自由に回ります。</translation>
    </message>
    <message>
        <source>The motor stops at once and holds.</source>
        <translation>モーターは直ちに停止して保持します。</translation>
    </message>
    <message>
        <source>The servo is switched ON and holds its position.</source>
        <translation>サーボをオンにし、位置を保持します。</translation>
    </message>
    <message>
        <source>The motor slows down with the loaded acceleration and holds.</source>
        <translation>モーターはロード済みの加速度で減速し、保持します。</translation>
    </message>
    <message>
        <source>The motor goes to this position without a profile, as fast as the gains drive it, and holds there.</source>
        <translation>モーターはプロファイルなしで、ゲインの許す限り速くこの位置へ動き、そこで保持します。</translation>
    </message>
    <message>
        <source>Set Homing Mode</source>
        <translation>Set Homing Mode</translation>
    </message>
    <message>
        <source>Send homing mode</source>
        <translation>原点復帰モードを送信</translation>
    </message>
    <message>
        <source>Change of limit 1</source>
        <translation>リミット1の変化</translation>
    </message>
    <message>
        <source>Change of limit 2</source>
        <translation>リミット2の変化</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>その後</translation>
    </message>
    <message>
        <source>Table 4 of the data sheet has no such mode for the present state of the motor.</source>
        <translation>モーターの現在の状態からは、データシートの表4にこのようなモードがありません。</translation>
    </message>
    <message>
        <source>Position (steps)</source>
        <translation>位置（ステップ）</translation>
    </message>
    <message>
        <source>Acceleration time (0.25 ms)</source>
        <translation>加速時間（0.25 ms）</translation>
    </message>
    <message>
        <source>Initial timer count</source>
        <translation>初期タイマー値</translation>
    </message>
    <message>
        <source>Nearest integer speed</source>
        <translation>最も近い整数速度</translation>
    </message>
    <message>
        <source>Reverse (not trapezoidal)</source>
        <translation>逆方向（台形以外）</translation>
    </message>
    <message>
        <source>Switches only AMP_EN. A motion in progress keeps counting.</source>
        <translation>AMP_ENだけを切り替えます。実行中の動作はカウントを続けます。</translation>
    </message>
    <message>
        <source>The steps end at once.</source>
        <translation>ステップは直ちに終わります。</translation>
    </message>
    <message>
        <source>The motor slows down with its acceleration time.</source>
        <translation>モーターは加速時間に従って減速します。</translation>
    </message>
    <message>
        <source>Change of the home switch</source>
        <translation>原点スイッチの変化</translation>
    </message>
    <message>
        <source>Commands as in the data sheet</source>
        <translation>データシートどおりのコマンド</translation>
    </message>
    <message>
        <source>Commands as in the data sheet, in native counts. STOP ALL and Esc work as usual.</source>
        <translation>データシートどおりのコマンドです（チップのカウント値）。全停止とEscは通常どおり使用できます。</translation>
    </message>
    <message>
        <source>%1 Waits for Start Motion; the next load overwrites it.</source>
        <translation>%1 Start Motionを待ちます。次のロードで上書きされます。</translation>
    </message>
    <message>
        <source>The servo is off; the PWM value drives the motor. No limit applies.</source>
        <translation>サーボはオフで、PWM値がモーターを駆動します。制限は一切働きません。</translation>
    </message>
    <message>
        <source>The motor runs until it is stopped.</source>
        <translation>モーターは停止操作をするまで運転を続けます。</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position. Start it only from standstill.</source>
        <translation>指定位置への台形移動です。必ず停止状態から開始してください。</translation>
    </message>
    <message>
        <source>A trapezoidal move to the position.</source>
        <translation>指定位置への台形移動です。</translation>
    </message>
    <message>
        <source>A ramp to the speed. The motor runs until it is stopped.</source>
        <translation>指定速度まで加減速します。モーターは停止操作をするまで運転を続けます。</translation>
    </message>
    <message>
        <source>One speed from the first step to the position.</source>
        <translation>最初のステップから指定位置まで一定速度です。</translation>
    </message>
    <message>
        <source>One speed from the first step. The motor runs until it is stopped.</source>
        <translation>最初のステップから一定速度です。モーターは停止操作をするまで運転を続けます。</translation>
    </message>
    <message>
        <source>The move continues to its position at this speed. If it has just ended, the motor runs until it is stopped.</source>
        <translation>この速度で指定位置まで移動を続けます。移動が終わった直後の場合、モーターは停止操作をするまで運転を続けます。</translation>
    </message>
    <message>
        <source>Reset module…</source>
        <translation>モジュールをリセット…</translation>
    </message>
    <message>
        <source>Reset module to its power-up state</source>
        <translation>モジュールをリセット：電源投入時の状態に戻す</translation>
    </message>
    <message>
        <source>Returns this module to its power-up state and assigns its address again. The other modules are unchanged.</source>
        <translation>このモジュールを電源投入時の状態に戻し、アドレスを割り当て直します。ほかのモジュールは変わりません。</translation>
    </message>
    <message>
        <source>Reset module</source>
        <translation>モジュールのリセット</translation>
    </message>
    <message>
        <source>Reset %1? Its motor switches off, and it loses its position, settings and group. The other modules are unchanged.</source>
        <translation>%1をリセットしますか？モーターはオフになり、位置、設定、グループが失われます。ほかのモジュールは変わりません。</translation>
    </message>
    <message>
        <source>Reset the module</source>
        <translation>モジュールをリセット</translation>
    </message>
    <message>
        <source>Relative (trapezoidal)</source>
        <translation>相対（台形）</translation>
    </message>
    <message>
        <source>A trapezoidal move by this many counts, from the command position. Start it only from standstill.</source>
        <translation>サーボの指令位置から、このカウント数だけ台形移動します。必ず停止状態から開始してください。</translation>
    </message>
    <message>
        <source>Advanced features on</source>
        <translation>拡張機能オン</translation>
    </message>
    <message>
        <source>Reset Position</source>
        <translation>Reset Position</translation>
    </message>
    <message>
        <source>Send reset position</source>
        <translation>Reset Positionを送信</translation>
    </message>
    <message>
        <source>To 0</source>
        <translation>0にする</translation>
    </message>
    <message>
        <source>Relative to home</source>
        <translation>原点基準</translation>
    </message>
    <message>
        <source>To a value</source>
        <translation>値を指定</translation>
    </message>
    <message>
        <source>The home register is subtracted from the position. Nothing moves.</source>
        <translation>位置から原点レジスターの値を引きます。何も動きません。</translation>
    </message>
    <message>
        <source>The position becomes this value. Nothing moves.</source>
        <translation>位置がこの値になります。何も動きません。</translation>
    </message>
</context>
<context>
    <name>nmc::FirstSteps</name>
    <message>
        <source>Show me</source>
        <translation>場所を表示</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>最初の手順</translation>
    </message>
    <message>
        <source>Show me: the next step</source>
        <translation>場所を表示：次の手順</translation>
    </message>
    <message>
        <source>Shows the control for the next step. Sends nothing.</source>
        <translation>次の手順で使う操作部を示します。何も送信しません。</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>手順%1 / %2：%3</translation>
    </message>
    <message>
        <source>Fill in gains</source>
        <translation>ゲインを入力</translation>
    </message>
    <message>
        <source>Apply gains</source>
        <translation>ゲインを適用</translation>
    </message>
    <message>
        <source>Enable servo</source>
        <translation>サーボオン</translation>
    </message>
    <message>
        <source>Take the starting values, or type your own. Nothing is sent yet.</source>
        <translation>初期値を使うか、値を入力してください。まだ何も送信しません。</translation>
    </message>
    <message>
        <source>Sends the gains to the module. The motor does not move.</source>
        <translation>ゲインをモジュールに送信します。モーターは動きません。</translation>
    </message>
    <message>
        <source>New wiring? Run the direction check on the Axis page first.</source>
        <translation>新しい配線の場合は、先に「軸」ページで方向チェックを行ってください。</translation>
    </message>
    <message>
        <source>The motor moves while you hold the button. Esc stops it from anywhere.</source>
        <translation>ボタンを押している間、モーターが動きます。Escを押せば、どの画面からでも停止します。</translation>
    </message>
</context>
<context>
    <name>nmc::FrequencyPage</name>
    <message>
        <source>Measure</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>The motor swings around its position, slowly at first, then faster. Make sure that everything it drives can move freely.</source>
        <translation>モーターが現在位置を中心に、最初はゆっくり、次第に速く揺れ動きます。駆動されるものがすべて自由に動けることを確認してください。</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>振幅</translation>
    </message>
    <message>
        <source>The amplitude</source>
        <translation>振幅の値</translation>
    </message>
    <message>
        <source>How far the command swings to either side. The motor is stopped if it swings four times as far.</source>
        <translation>指令が左右それぞれに振れる量です。モーターがその4倍振れると停止します。</translation>
    </message>
    <message>
        <source>From</source>
        <translation>最低</translation>
    </message>
    <message>
        <source>The lowest frequency</source>
        <translation>最低周波数</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>To</source>
        <translation>最高</translation>
    </message>
    <message>
        <source>The highest frequency</source>
        <translation>最高周波数</translation>
    </message>
    <message>
        <source>The test ends earlier if the baud rate is too low: at about 40 Hz at 115 200 Bd, and at about 8 Hz at 19 200 Bd.</source>
        <translation>ボーレートが低すぎると、テストは早く終わります。115200 Bdでは約40 Hz、19200 Bdでは約8 Hzです。</translation>
    </message>
    <message>
        <source>Results of the frequency response</source>
        <translation>周波数応答の結果</translation>
    </message>
    <message>
        <source>Export CSV of the frequency response</source>
        <translation>CSVエクスポート：周波数応答</translation>
    </message>
    <message>
        <source>The baud rate is too low for higher frequencies.</source>
        <translation>ボーレートが低すぎて、これより高い周波数は測定できません。</translation>
    </message>
    <message>
        <source>No measurement yet.</source>
        <translation>まだ測定していません。</translation>
    </message>
    <message>
        <source>Saves frequency, magnitude and phase of the open and the closed loop.</source>
        <translation>開ループと閉ループの周波数、ゲイン、位相を保存します。</translation>
    </message>
    <message>
        <source>Export the frequency response</source>
        <translation>周波数応答のエクスポート</translation>
    </message>
    <message>
        <source>Speed while measuring</source>
        <translation>測定中の速度</translation>
    </message>
    <message>
        <source>The speed while measuring</source>
        <translation>測定中の速度の値</translation>
    </message>
    <message>
        <source>0: at rest. Otherwise the sines ride on a motion to and fro, forward first, or backwards first if it is negative; the motor never reverses within a sine, so dry friction does not show. It moves away by up to this speed times five periods of the lowest frequency.</source>
        <translation>0：停止状態。それ以外では、正弦波が往復運動に重なります（最初は前進、負の値では最初に後退）。正弦波の途中でモーターが反転しないため、乾性摩擦が現れません。最低周波数の5周期分×この速度まで移動します。</translation>
    </message>
    <message>
        <source>What the gains in the fields would do</source>
        <translation>入力欄のゲインでの応答</translation>
    </message>
    <message>
        <source>in motion</source>
        <translation>運動中</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Fill in all gains to see what this loop would do with them.</source>
        <translation>すべてのゲインを入力すると、そのゲインでのこのループの応答を確認できます。</translation>
    </message>
    <message>
        <source>with the gains in the fields</source>
        <translation>入力欄のゲインで</translation>
    </message>
    <message>
        <source>The last measurement ended early. The one before it is still shown.</source>
        <translation>最後の測定は途中で終了しました。その前の測定を引き続き表示しています。</translation>
    </message>
</context>
<context>
    <name>nmc::GainsBox</name>
    <message>
        <source>&amp;Apply gains</source>
        <translation>ゲインを適用(&amp;A)</translation>
    </message>
    <message>
        <source>Apply gains: all</source>
        <translation>ゲインを適用：すべて</translation>
    </message>
    <message>
        <source>Revert the gains to those last sent</source>
        <translation>編集を破棄：最後に送信したゲインに戻す</translation>
    </message>
    <message>
        <source>Fills in values to start tuning with. Sends nothing.</source>
        <translation>調整を始めるための値を入力します。何も送信しません。</translation>
    </message>
    <message>
        <source>Gains cannot be read back from the module. They are unknown until you apply them.</source>
        <translation>ゲインはモジュールから読み出せません。適用するまで不明です。</translation>
    </message>
    <message>
        <source>Sends all gains at once. The servo is on: they take effect immediately.</source>
        <translation>すべてのゲインを一度に送信します。サーボがオンのため、直ちに有効になります。</translation>
    </message>
    <message>
        <source>Sends all gains at once. The motor does not move.</source>
        <translation>すべてのゲインを一度に送信します。モーターは動きません。</translation>
    </message>
    <message>
        <source>&amp;Apply live</source>
        <translation>即時適用(&amp;A)</translation>
    </message>
    <message>
        <source>Restores the gains last sent. Sends nothing.</source>
        <translation>最後に送信したゲインに戻します。何も送信しません。</translation>
    </message>
    <message>
        <source>Clears the fields: no gains have been sent yet. Sends nothing.</source>
        <translation>欄を空にします。ゲインはまだ送信していません。何も送信しません。</translation>
    </message>
    <message>
        <source>Sense of the current limit</source>
        <translation>電流制限の極性</translation>
    </message>
    <message>
        <source>Whether a high or a low A/D value means overcurrent. The chip distinguishes them by odd and even values.</source>
        <translation>A/D値が高いときと低いときのどちらを過電流とみなすかを選びます。チップは奇数と偶数で区別します。</translation>
    </message>
    <message>
        <source>Undo the last edit of a gain</source>
        <translation>元に戻す：ゲインの最後の編集</translation>
    </message>
    <message>
        <source>Redo the last undone edit of a gain</source>
        <translation>やり直し：ゲインの編集</translation>
    </message>
    <message>
        <source>All zero</source>
        <translation>すべて0</translation>
    </message>
    <message>
        <source>All zero: fill in 0 for all gains</source>
        <translation>すべて0：全ゲインに0を入力</translation>
    </message>
    <message>
        <source>Changing SR from %2 to %1 changes the servo tick, and with it the meaning of every velocity and acceleration in counts per tick.</source>
        <translation>SRを%2から%1に変えるとサーボ周期が変わり、カウント/周期で表すすべての速度と加速度の意味も変わります。</translation>
    </message>
    <message>
        <source>Gains while the servo is on</source>
        <translation>サーボオン中のゲイン</translation>
    </message>
    <message>
        <source>The servo is on, and the gains in the module are unknown, so this may be a large change. The motor may jump or oscillate.</source>
        <translation>サーボがオンで、モジュールのゲインが不明なため、大きな変更になる可能性があります。モーターが急に動くか、発振するおそれがあります。</translation>
    </message>
    <message>
        <source>The servo is on, and this is a large change: %1. The motor may jump or oscillate.</source>
        <translation>サーボがオンで、大きな変更です：%1。モーターが急に動くか、発振するおそれがあります。</translation>
    </message>
    <message>
        <source>&amp;Apply these gains</source>
        <translation>このゲインを適用(&amp;A)</translation>
    </message>
    <message>
        <source>Step response…</source>
        <translation>ステップ応答…</translation>
    </message>
    <message>
        <source>Step response: open</source>
        <translation>ステップ応答：開く</translation>
    </message>
    <message>
        <source>Opens the step response, which shows how the motor follows a small step (F9).</source>
        <translation>モーターが小さなステップにどう追従するかを示すステップ応答を開きます（F9）。</translation>
    </message>
    <message>
        <source>Fills the fields with 0, to start tuning. Sends nothing. Once applied, the motor no longer holds.</source>
        <translation>調整を始めるために欄を0にします。何も送信しません。適用すると、モーターは保持しなくなります。</translation>
    </message>
    <message>
        <source>Try for %1 s</source>
        <translation>%1秒試用</translation>
    </message>
    <message>
        <source>Try for %1 s: these gains</source>
        <translation>%1秒試用：このゲイン</translation>
    </message>
    <message>
        <source>Keep gains</source>
        <translation>ゲインを採用</translation>
    </message>
    <message>
        <source>Keep gains: those being tried</source>
        <translation>ゲインを採用：試用中のもの</translation>
    </message>
    <message>
        <source>These gains are already being tried.</source>
        <translation>このゲインはすでに試用中です。</translation>
    </message>
    <message>
        <source>The module already has these gains.</source>
        <translation>モジュールはすでにこのゲインになっています。</translation>
    </message>
    <message>
        <source>Sends these gains and restores the previous ones after %1 s unless you keep them, or at once if the motor starts to oscillate.</source>
        <translation>このゲインを送信します。採用しなければ%1秒後に、モーターが発振し始めたら直ちに、以前のゲインに戻します。</translation>
    </message>
    <message>
        <source>No gains are being tried.</source>
        <translation>試用中のゲインはありません。</translation>
    </message>
    <message>
        <source>Keeps the gains that are being tried.</source>
        <translation>試用中のゲインを採用します。</translation>
    </message>
    <message>
        <source>Apply live: all gains</source>
        <translation>即時適用：すべてのゲイン</translation>
    </message>
    <message>
        <source>no current limit</source>
        <translation>制限なし</translation>
    </message>
    <message>
        <source>limits above (odd)</source>
        <translation>超過で制限（奇数）</translation>
    </message>
    <message>
        <source>limits below (even)</source>
        <translation>未満で制限（偶数）</translation>
    </message>
    <message>
        <source>Range: %1 to %2.</source>
        <translation>範囲：%1～%2。</translation>
    </message>
</context>
<context>
    <name>nmc::GenericPanel</name>
    <message>
        <source>Module without controls</source>
        <translation>操作項目のないモジュール</translation>
    </message>
    <message>
        <source>No status yet.</source>
        <translation>ステータスはまだありません。</translation>
    </message>
    <message>
        <source>Status byte %1</source>
        <translation>ステータスバイト%1</translation>
    </message>
    <message>
        <source>, position %1</source>
        <translation>、位置%1</translation>
    </message>
    <message>
        <source>It does not answer. </source>
        <translation>応答がありません。</translation>
    </message>
    <message>
        <source>Request status</source>
        <translation>ステータスを要求</translation>
    </message>
    <message>
        <source>Sends No Operation, which only requests the status.</source>
        <translation>No Operationを送信します。ステータスを要求するだけです。</translation>
    </message>
    <message>
        <source>The panel does not support this type and version (supported: PIC-SERVO v1 to v5 and v10, PIC-STEP v1, PIC-I/O v1), so it only shows the module&apos;s status. STOP ALL might not stop its motor: use the hardware stop.</source>
        <translation>このタイプとバージョンにはパネルが対応していないため（対応：PIC-SERVO v1～v5およびv10、PIC-STEP v1、PIC-I/O v1）、モジュールのステータスだけを表示します。全停止ではモーターが止まらない可能性があります。ハードウェア停止を使用してください。</translation>
    </message>
</context>
<context>
    <name>nmc::GroupsPage</name>
    <message>
        <source>No modules yet: connect first.</source>
        <translation>モジュールがありません。先に接続してください。</translation>
    </message>
    <message>
        <source>Group to command</source>
        <translation>指令するグループ</translation>
    </message>
    <message>
        <source>St&amp;art loaded moves</source>
        <translation>ロード済みの移動を開始(&amp;A)</translation>
    </message>
    <message>
        <source>Start loaded moves of this group</source>
        <translation>ロード済みの移動を開始：このグループ</translation>
    </message>
    <message>
        <source>Save &amp;home</source>
        <translation>原点を保存(&amp;H)</translation>
    </message>
    <message>
        <source>Save home: the present positions of this group</source>
        <translation>原点を保存：このグループの現在位置</translation>
    </message>
    <message>
        <source>Group of module %1</source>
        <translation>モジュール%1のグループ</translation>
    </message>
    <message>
        <source>The group that this module listens to. Sent at once; nothing moves.</source>
        <translation>このモジュールが従うグループです。直ちに送信されます。何も動きません。</translation>
    </message>
    <message>
        <source>leader</source>
        <translation>リーダー</translation>
    </message>
    <message>
        <source>Leader of its group: module %1</source>
        <translation>リーダー（グループの）：モジュール%1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Choose a group first.</source>
        <translation>先にグループを選択してください。</translation>
    </message>
    <message>
        <source>This module answers for its group. A group has at most one leader.</source>
        <translation>このモジュールがグループを代表して応答します。リーダーは1グループに1台までです。</translation>
    </message>
    <message>
        <source>move loaded</source>
        <translation>移動ロード済み</translation>
    </message>
    <message>
        <source>No groups yet. Add modules to a group first.</source>
        <translation>グループがありません。先にモジュールをグループに追加してください。</translation>
    </message>
    <message>
        <source>Starts the loaded moves of all members in the same tick. Available once every member has confirmed its load.</source>
        <translation>全メンバーのロード済みの移動を同じ周期に開始します。全メンバーがロードを確認応答すると使用できます。</translation>
    </message>
    <message>
        <source>Saves the present position of each member as home, in the same tick. Nothing moves.</source>
        <translation>各メンバーの現在位置を、同じ周期に原点として保存します。何も動きません。</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>グループの名前</translation>
    </message>
    <message>
        <source>The name of this group. Saved with the machine; nothing is sent.</source>
        <translation>このグループの名前です。マシンとともに保存され、何も送信されません。</translation>
    </message>
    <message>
        <source>A module listens to one group besides its own address. All members carry out a group command in the same tick; the leader, if any, answers for them, and the panel then checks each member. Status requests go to single modules.</source>
        <translation>モジュールは自分のアドレスに加えて、1つのグループに従います。グループコマンドは全メンバーが同じ周期に実行し、リーダーがいれば代表して応答します。その後、パネルが各メンバーを確認します。ステータス要求は個々のモジュールに送られます。</translation>
    </message>
    <message>
        <source>The group that the buttons act on.</source>
        <translation>ボタンで指令するグループです。</translation>
    </message>
    <message>
        <source>Stop s&amp;moothly</source>
        <translation>減速停止(&amp;M)</translation>
    </message>
    <message>
        <source>Stop smoothly: this group</source>
        <translation>減速停止：このグループ</translation>
    </message>
    <message>
        <source>Stop at &amp;once</source>
        <translation>即停止(&amp;O)</translation>
    </message>
    <message>
        <source>Stop at once: this group</source>
        <translation>即停止：このグループ</translation>
    </message>
    <message>
        <source>Motors o&amp;ff</source>
        <translation>モーターオフ(&amp;F)</translation>
    </message>
    <message>
        <source>Motors off in this group</source>
        <translation>モーターオフ：このグループ</translation>
    </message>
    <message>
        <source>C&amp;lear sticky bits</source>
        <translation>スティッキービットをクリア(&amp;L)</translation>
    </message>
    <message>
        <source>Clear sticky bits of this group</source>
        <translation>スティッキービットをクリア：このグループ</translation>
    </message>
    <message>
        <source>Set &amp;position to 0…</source>
        <translation>位置を0に設定(&amp;P)…</translation>
    </message>
    <message>
        <source>Set position to 0 for this group</source>
        <translation>位置を0に設定：このグループ</translation>
    </message>
    <message>
        <source>Address of module %1</source>
        <translation>モジュール%1のアドレス</translation>
    </message>
    <message>
        <source>The address of this module, 1 to 127. Press Enter to send it. Position, gains and group are kept.</source>
        <translation>このモジュールのアドレス（1～127）です。Enterで送信します。位置、ゲイン、グループは保たれます。</translation>
    </message>
    <message>
        <source>Makes the present position of each member 0. Asks first.</source>
        <translation>各メンバーの現在位置を0にします。実行前に確認します。</translation>
    </message>
    <message>
        <source>Clears the sticky fault bits of each member. PIC-SERVO only.</source>
        <translation>各メンバーの異常のスティッキービットをクリアします。PIC-SERVOのみ。</translation>
    </message>
    <message>
        <source>Every member that is on slows down and holds. Repeated until all are seen at rest.</source>
        <translation>オンの全メンバーが減速し、保持します。全台の停止を確認するまで繰り返します。</translation>
    </message>
    <message>
        <source>Every member that is on stops at once and holds. Repeated until all are seen at rest.</source>
        <translation>オンの全メンバーが直ちに停止し、保持します。全台の停止を確認するまで繰り返します。</translation>
    </message>
    <message>
        <source>Switches every member off: motors coast, and loads may fall. Repeated until all are seen at rest.</source>
        <translation>全メンバーをオフにします。モーターは惰走し、負荷が落下することがあります。全台の停止を確認するまで繰り返します。</translation>
    </message>
    <message>
        <source>The present position of each motor of %1 becomes 0: module %2. Home, limits and taught points then refer to different positions.</source>
        <translation>%1の各モーターの現在位置が0になります：モジュール%2。原点、制限、教示済みポイントの示す場所が変わります。</translation>
    </message>
    <message>
        <source>Set positions to 0</source>
        <translation>位置を0に設定</translation>
    </message>
    <message>
        <source>&amp;Set positions to 0</source>
        <translation>位置を0に設定(&amp;S)</translation>
    </message>
    <message>
        <source>Its group is unknown and would change with the address. Choose a group first, or none.</source>
        <translation>グループが不明で、アドレスとともに変わってしまいます。先にグループを選択するか、「なし」にしてください。</translation>
    </message>
    <message>
        <source>A motor is moving. Stop all motors to change addresses.</source>
        <translation>モーターが動いています。アドレスを変更するには、すべてのモーターを停止してください。</translation>
    </message>
    <message>
        <source>Address %1 is used by %2. Nothing was sent.</source>
        <translation>アドレス%1は%2が使用しています。何も送信していません。</translation>
    </message>
    <message>
        <source>outputs stored</source>
        <translation>出力格納済み</translation>
    </message>
    <message>
        <source>Store its outputs first.</source>
        <translation>先にこのモジュールの出力を格納してください。</translation>
    </message>
    <message>
        <source>The address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>address</source>
        <translation>アドレス</translation>
    </message>
</context>
<context>
    <name>nmc::HoldFirstButton</name>
    <message>
        <source>Hold here first</source>
        <translation>先にここで保持</translation>
    </message>
    <message>
        <source>Holds the motor at its present position (Stop here).</source>
        <translation>モーターを現在位置で保持します（「ここで停止」）。</translation>
    </message>
</context>
<context>
    <name>nmc::HomingBox</name>
    <message>
        <source>Home</source>
        <translation>原点復帰</translation>
    </message>
    <message>
        <source>Cancel search</source>
        <translation>サーチを中止</translation>
    </message>
    <message>
        <source>Home: search for it</source>
        <translation>原点復帰：原点をサーチ</translation>
    </message>
    <message>
        <source>Cancel search for home</source>
        <translation>サーチを中止：原点サーチ</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>サーチの進行状況</translation>
    </message>
    <message>
        <source>Moves the motor to search for home, as set above.</source>
        <translation>上の設定に従い、モーターを動かして原点をサーチします。</translation>
    </message>
    <message>
        <source>No search for home is running.</source>
        <translation>原点サーチは実行していません。</translation>
    </message>
    <message>
        <source>Stops the motor smoothly, without homing it.</source>
        <translation>モーターを減速停止します。原点復帰は行われません。</translation>
    </message>
    <message>
        <source>Done: home was at %1.</source>
        <translation>完了：原点は%1にありました。</translation>
    </message>
    <message>
        <source>No search yet.</source>
        <translation>サーチはまだ行っていません。</translation>
    </message>
</context>
<context>
    <name>nmc::HomingForm</name>
    <message>
        <source>Search for home</source>
        <translation>原点サーチ</translation>
    </message>
    <message>
        <source>Home is where this switch changes. If it is active at the start, the motor first backs off in the other direction.</source>
        <translation>このスイッチが変化する場所が原点です。開始時にオンの場合、モーターはまず反対方向に退避します。</translation>
    </message>
    <message>
        <source>Limit 1 (forward)</source>
        <translation>リミット1（正方向）</translation>
    </message>
    <message>
        <source>Limit 2 (reverse)</source>
        <translation>リミット2（逆方向）</translation>
    </message>
    <message>
        <source>Home is at</source>
        <translation>原点の条件</translation>
    </message>
    <message>
        <source>Home is at the encoder&apos;s index, which comes once per turn.</source>
        <translation>1回転に1回現れるエンコーダーのインデックスが原点です。</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the position error limit switches the servo off. Sticky bits are cleared first. The servo is switched on again only to continue to the index or to home.</source>
        <translation>メカストッパーが原点です。位置偏差上限でサーボがオフになるまで、モーターを突き当てます。先にスティッキービットをクリアします。サーボを再びオンにするのは、続けてインデックスまたは原点へ移動するときだけです。</translation>
    </message>
    <message>
        <source>Home is at a hard stop: the motor runs against it until the current limit is reached. On its own, it takes effect only at full speed; combined with other conditions, from the start, so the starting current must stay below it. Sticky bits are cleared first.</source>
        <translation>メカストッパーが原点です。電流制限に達するまで、モーターを突き当てます。単独では全速のときだけ働きます。ほかの条件と併用すると開始時から働くため、始動電流はこれより低くなければなりません。先にスティッキービットをクリアします。</translation>
    </message>
    <message>
        <source>then at the index, going back</source>
        <translation>続いて戻りながらインデックス</translation>
    </message>
    <message>
        <source>The conditions above find the approximate place; a second, slower search finds the index, which is more exact.</source>
        <translation>上の条件でおよその場所を見つけ、2回目の遅いサーチで、より正確なインデックスを見つけます。</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>逆方向</translation>
    </message>
    <message>
        <source>Reverse: search direction</source>
        <translation>逆方向：サーチ方向</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>正方向</translation>
    </message>
    <message>
        <source>Forward: search direction</source>
        <translation>正方向：サーチ方向</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Maximum velocity for searching, backing off and going to home.</source>
        <translation>サーチ、退避、原点への移動の最高速度です。</translation>
    </message>
    <message>
        <source>Index velocity</source>
        <translation>インデックス速度</translation>
    </message>
    <message>
        <source>Velocity of the second search, for the index. Slower is more exact.</source>
        <translation>インデックスを探す2回目のサーチの速度です。遅いほど正確です。</translation>
    </message>
    <message>
        <source>Also used for smooth stops.</source>
        <translation>減速停止にも使用します。</translation>
    </message>
    <message>
        <source>Search distance</source>
        <translation>サーチ距離</translation>
    </message>
    <message>
        <source>A search, or backing off, stops and fails after this distance.</source>
        <translation>サーチまたは退避は、この距離を超えると停止し、失敗となります。</translation>
    </message>
    <message>
        <source>Time limit of a search</source>
        <translation>サーチの制限時間</translation>
    </message>
    <message>
        <source>A search stops and fails after this time.</source>
        <translation>サーチは、この時間を超えると停止し、失敗となります。</translation>
    </message>
    <message>
        <source>%1 of the search for home</source>
        <translation>原点サーチの%1</translation>
    </message>
    <message>
        <source>Abruptly: stop at home</source>
        <translation>即停止：原点で</translation>
    </message>
    <message>
        <source>Smoothly: stop at home</source>
        <translation>減速停止：原点で</translation>
    </message>
    <message>
        <source>Motor off at home</source>
        <translation>モーターオフ：原点で</translation>
    </message>
    <message>
        <source>Stop there</source>
        <translation>停止方法</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>その後</translation>
    </message>
    <message>
        <source>Go to home</source>
        <translation>原点へ移動</translation>
    </message>
    <message>
        <source>The motor stops past home; this moves it back. If the search has switched the servo or amplifier off, it is switched on again.</source>
        <translation>モーターは原点を過ぎて停止するため、原点へ戻します。サーチでサーボまたはアンプがオフになった場合は、再びオンにします。</translation>
    </message>
    <message>
        <source>Set position to 0</source>
        <translation>位置を0に設定</translation>
    </message>
    <message>
        <source>The first search already finds the index.</source>
        <translation>最初のサーチでインデックスが見つかります。</translation>
    </message>
    <message>
        <source>Needs Go to home, because the position at which the motor rests becomes 0.</source>
        <translation>「原点へ移動」が必要です。モーターのある位置が0になります。</translation>
    </message>
    <message>
        <source>The search direction, in which the switch closes.</source>
        <translation>サーチ方向です。この方向に動くとスイッチが閉じます。</translation>
    </message>
    <message>
        <source>A position error switches the servo off.</source>
        <translation>位置偏差でサーボがオフになります。</translation>
    </message>
    <message>
        <source> This chip version does not stop the motor by itself: the panel stops it, a few hundredths of a second later.</source>
        <translation>このバージョンのチップは自動では停止しません。パネルが数十ミリ秒後に停止します。</translation>
    </message>
    <message>
        <source> The chip stops it by itself.</source>
        <translation>チップが自動で停止します。</translation>
    </message>
    <message>
        <source>At home the motor stops at once and holds.</source>
        <translation>原点でモーターは直ちに停止し、保持します。</translation>
    </message>
    <message>
        <source>At home the motor slows down, stops past it and holds.</source>
        <translation>原点でモーターは減速し、原点を過ぎて停止し、保持します。</translation>
    </message>
    <message>
        <source>At home the motor is switched off and is free to turn.</source>
        <translation>原点でモーターをオフにします。モーターは自由に回ります。</translation>
    </message>
    <message>
        <source>Once the motor is at home, its position becomes 0.</source>
        <translation>モーターが原点に達すると、その位置が0になります。</translation>
    </message>
    <message>
        <source>Limit 1 (reverse)</source>
        <translation>リミット1（逆方向）</translation>
    </message>
    <message>
        <source>Limit 2 (forward)</source>
        <translation>リミット2（正方向）</translation>
    </message>
</context>
<context>
    <name>nmc::IoBox</name>
    <message>
        <source>Limits and I/O</source>
        <translation>リミットとI/O</translation>
    </message>
    <message>
        <source>The encoder&apos;s index pulse, once per turn with most encoders.</source>
        <translation>エンコーダーのインデックスパルスです。多くのエンコーダーでは1回転に1回です。</translation>
    </message>
    <message>
        <source>Without motor power the servo switches off, and stays off when power returns.</source>
        <translation>モーター電源がないとサーボはオフになり、電源が戻ってもオフのままです。</translation>
    </message>
    <message>
        <source>The A/D input; with most amplifiers, the motor current. Set its scale on the Axis page.</source>
        <translation>A/D入力です。多くのアンプではモーター電流です。スケールは「軸」ページで設定します。</translation>
    </message>
    <message>
        <source>Amplifier enabled (&amp;AMP_EN)</source>
        <translation>アンプ有効 (&amp;AMP_EN)</translation>
    </message>
    <message>
        <source>On this chip, a limit switch alone does not stop the motor. Arm a limit stop on the Homing page.</source>
        <translation>このチップでは、リミットスイッチだけではモーターは停止しません。「原点復帰」ページでリミット停止を有効にしてください。</translation>
    </message>
    <message>
        <source>Limit &amp;1</source>
        <translation>リミット1(&amp;1)</translation>
    </message>
    <message>
        <source>Limit &amp;2</source>
        <translation>リミット2(&amp;2)</translation>
    </message>
    <message>
        <source>Limit %1: input or output</source>
        <translation>リミット%1：入力または出力</translation>
    </message>
    <message>
        <source>output, low</source>
        <translation>出力、Low</translation>
    </message>
    <message>
        <source>output, high</source>
        <translation>出力、High</translation>
    </message>
    <message>
        <source>Another program set up this module, so its pin directions are unknown. Nothing is sent until all are chosen.</source>
        <translation>別のプログラムがこのモジュールを設定したため、ピンの方向が不明です。すべてを選択するまで何も送信されません。</translation>
    </message>
    <message>
        <source>Makes the pin an input, or an output with this level. Sent at once.</source>
        <translation>ピンを入力、またはこのレベルの出力にします。直ちに送信されます。</translation>
    </message>
    <message>
        <source>at the index</source>
        <translation>インデックス位置</translation>
    </message>
    <message>
        <source>not at the index</source>
        <translation>インデックス位置以外</translation>
    </message>
    <message>
        <source>present</source>
        <translation>あり</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Switches only the amplifier&apos;s enable line; the servo stays as it is. When off, the motor gets no current, whatever the servo does.</source>
        <translation>アンプのイネーブル線だけを切り替えます。サーボはそのままです。オフにすると、サーボの動作に関係なく、モーターに電流は流れません。</translation>
    </message>
    <message>
        <source>The Amplifier page sets what the module does when a limit closes.</source>
        <translation>リミットが閉じたときのモジュールの動作は、「アンプ」ページで設定します。</translation>
    </message>
    <message>
        <source>Path points at 60 and 120 Hz instead of 30 and 60 Hz. Sent at once.</source>
        <translation>パスの点は30/60 Hzではなく、60/120 Hzになります。直ちに送信されます。</translation>
    </message>
</context>
<context>
    <name>nmc::IoHead</name>
    <message>
        <source>Name of this module</source>
        <translation>このモジュールの名前</translation>
    </message>
    <message>
        <source>Last answer: %1.</source>
        <translation>最後の応答：%1。</translation>
    </message>
</context>
<context>
    <name>nmc::IoPanel</name>
    <message>
        <source>I/O module</source>
        <translation>I/Oモジュール</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>カウンター</translation>
    </message>
</context>
<context>
    <name>nmc::IoValuesBox</name>
    <message>
        <source>Reads</source>
        <translation>読み取り値</translation>
    </message>
    <message>
        <source>Per count</source>
        <translation>1刻み</translation>
    </message>
    <message>
        <source>At 0</source>
        <translation>0のとき</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>%1の値</translation>
    </message>
    <message>
        <source>%1 per count</source>
        <translation>%1、1刻み</translation>
    </message>
    <message>
        <source>The value of one A/D count.</source>
        <translation>A/D 1カウントの値です。</translation>
    </message>
    <message>
        <source>The unit of the value.</source>
        <translation>値の単位。</translation>
    </message>
    <message>
        <source>%1 at 0</source>
        <translation>%1、0のとき</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>%1の単位</translation>
    </message>
    <message>
        <source>PWM output</source>
        <translation>PWM出力</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>0 to 255</source>
        <translation>0～255</translation>
    </message>
    <message>
        <source>Last value sent to %1</source>
        <translation>%1への最終送信値</translation>
    </message>
    <message>
        <source>255 is always on. Press Enter to send.</source>
        <translation>255で常時オンです。Enterで送信します。</translation>
    </message>
    <message>
        <source>Switch %1 off on STOP ALL</source>
        <translation>停止でオフ：全停止で%1をオフ</translation>
    </message>
    <message>
        <source>STOP ALL switches this output off. If cleared, the output stays as it is.</source>
        <translation>全停止でこの出力をオフにします。チェックを外すと、出力はそのまま残ります。</translation>
    </message>
    <message>
        <source>The PWM values are unknown. Enter one for each output: both are sent together.</source>
        <translation>PWM値が不明です。出力ごとに値を入力してください。両方が一緒に送信されます。</translation>
    </message>
</context>
<context>
    <name>nmc::JogBox</name>
    <message>
        <source>Jog speed</source>
        <translation>ジョグ速度</translation>
    </message>
    <message>
        <source>Hold to move in reverse</source>
        <translation>◂ ジョグ：押している間、逆方向に移動</translation>
    </message>
    <message>
        <source>Hold to move forward</source>
        <translation>ジョグ ▸：押している間、正方向に移動</translation>
    </message>
    <message>
        <source>How fast the motor turns while you hold a button, or Space on it. Returns to a low value at each connection; set the max jog speed on the Axis page.</source>
        <translation>ボタン、またはその上でスペースキーを押している間のモーターの速度です。接続のたびに低い値に戻ります。最高ジョグ速度は「軸」ページで設定します。</translation>
    </message>
    <message>
        <source>J&amp;og speed</source>
        <translation>ジョグ速度(&amp;O)</translation>
    </message>
    <message>
        <source>How fast the motor turns while you hold a button, or Space on it: %1 to %2. Set the max jog speed on the Parameters page.</source>
        <translation>ボタン、またはその上でスペースキーを押している間のモーターの速度です：%1～%2。最高ジョグ速度は「パラメーター」ページで設定します。</translation>
    </message>
</context>
<context>
    <name>nmc::Layouts</name>
    <message>
        <source>&amp;Operate</source>
        <translation>操作(&amp;O)</translation>
    </message>
    <message>
        <source>Motion in the middle, everything else around it.</source>
        <translation>動作を中央に、ほかを周囲に配置します。</translation>
    </message>
    <message>
        <source>&amp;Tune</source>
        <translation>調整(&amp;T)</translation>
    </message>
    <message>
        <source>Large plots, with gains and step response beside them.</source>
        <translation>大きなグラフの横に、ゲインとステップ応答を配置します。</translation>
    </message>
    <message>
        <source>&amp;Chain</source>
        <translation>チェーン(&amp;C)</translation>
    </message>
    <message>
        <source>Modules, packets and messages.</source>
        <translation>モジュール、パケット、メッセージ。</translation>
    </message>
</context>
<context>
    <name>nmc::LendDialog</name>
    <message>
        <source>Path of the terminal</source>
        <translation>端末のパス</translation>
    </message>
    <message>
        <source>&amp;Lend the line</source>
        <translation>回線を貸す(&amp;L)</translation>
    </message>
    <message>
        <source>Lend the line to a program</source>
        <translation>プログラムに回線を貸す</translation>
    </message>
    <message>
        <source>The program opens this path in place of the serial port, and has the modules for itself. The panel shows and records what they report, and sends nothing: your travel limits, stops at limits and other checks do not protect the motors. STOP ALL works, and holds the program off.</source>
        <translation>プログラムはシリアルポートの代わりにこのパスを開き、モジュールを占有します。パネルは報告を表示・記録するだけで、何も送信しません。移動範囲、リミットでの停止などの確認はモーターを保護しません。全停止は有効で、プログラムを保留します。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Path of the terminal</source>
        <translation>端末のパス(&amp;P)</translation>
    </message>
    <message>
        <source>A motor is moving. Stop it first.</source>
        <translation>モーターが動いています。先に停止してください。</translation>
    </message>
    <message>
        <source>Enter a path.</source>
        <translation>パスを入力してください。</translation>
    </message>
    <message>
        <source>Creates the terminal. Nothing moves.</source>
        <translation>端末を作ります。何も動きません。</translation>
    </message>
</context>
<context>
    <name>nmc::LimitStopBox</name>
    <message>
        <source>Arm limit stop</source>
        <translation>リミット停止を有効化</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>無効化</translation>
    </message>
    <message>
        <source>Limit 1: stop there</source>
        <translation>リミット1：そこで停止</translation>
    </message>
    <message>
        <source>Limit 2: stop there</source>
        <translation>リミット2：そこで停止</translation>
    </message>
    <message>
        <source>Disarm limit stop</source>
        <translation>無効化：リミット停止</translation>
    </message>
    <message>
        <source>State of the limit stop</source>
        <translation>リミット停止の状態</translation>
    </message>
    <message>
        <source>Abruptly: stop at the limit</source>
        <translation>即停止：リミットで</translation>
    </message>
    <message>
        <source>Smoothly: stop at the limit</source>
        <translation>減速停止：リミットで</translation>
    </message>
    <message>
        <source>Motor off at the limit</source>
        <translation>モーターオフ：リミットで</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>停止条件</translation>
    </message>
    <message>
        <source>Select a limit switch first.</source>
        <translation>先にリミットスイッチを選択してください。</translation>
    </message>
    <message>
        <source>The motor stops when limit switch 1 changes.</source>
        <translation>リミットスイッチ1が変化すると、モーターが停止します。</translation>
    </message>
    <message>
        <source>The motor stops when limit switch 2 changes.</source>
        <translation>リミットスイッチ2が変化すると、モーターが停止します。</translation>
    </message>
    <message>
        <source>At the limit the motor stops at once and holds.</source>
        <translation>リミットでモーターは直ちに停止し、保持します。</translation>
    </message>
    <message>
        <source>At the limit the motor slows down, stops past it and holds.</source>
        <translation>リミットでモーターは減速し、リミットを過ぎて停止し、保持します。</translation>
    </message>
    <message>
        <source>At the limit the motor is switched off and is free to turn.</source>
        <translation>リミットでモーターをオフにします。モーターは自由に回ります。</translation>
    </message>
    <message>
        <source>The chip itself then stops the motor once when a selected limit switch changes, faster than the panel could. A search for home replaces it.</source>
        <translation>選択したリミットスイッチが変化すると、チップ自身が1回だけ、パネルより速くモーターを停止します。原点サーチを行うと、これは解除されます。</translation>
    </message>
    <message>
        <source>The limit stop is not armed.</source>
        <translation>リミット停止は有効になっていません。</translation>
    </message>
    <message>
        <source>A limit switch no longer stops the motor.</source>
        <translation>リミットスイッチではモーターが停止しなくなります。</translation>
    </message>
    <message>
        <source>○ Not armed: a limit switch alone does not stop the motor.</source>
        <translation>○ 無効：リミットスイッチだけではモーターは停止しません。</translation>
    </message>
    <message>
        <source>○ This chip version cannot stop at a limit switch.</source>
        <translation>○ このバージョンのチップは、リミットスイッチで停止できません。</translation>
    </message>
    <message>
        <source>● Armed: stops at %1, once.</source>
        <translation>● 有効：%1で停止、1回のみ。</translation>
    </message>
    <message>
        <source>▲ Tripped by %1; the motor was stopped. No longer armed.</source>
        <translation>▲ 作動：%1によりモーターを停止しました。現在は無効です。</translation>
    </message>
    <message>
        <source>? The chip watches for an event that this connection did not request.</source>
        <translation>? チップは、この接続で要求していない事象を監視しています。</translation>
    </message>
    <message>
        <source>the position error limit</source>
        <translation>位置偏差上限</translation>
    </message>
    <message>
        <source>the current limit</source>
        <translation>電流制限</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1または%2</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>電流</translation>
    </message>
    <message>
        <source>for each motion of this axis</source>
        <translation>この軸の動作ごと</translation>
    </message>
    <message>
        <source>Position error stops the motor</source>
        <translation>位置偏差：モーターを停止</translation>
    </message>
    <message>
        <source>Current stops the motor</source>
        <translation>電流：モーターを停止</translation>
    </message>
    <message>
        <source>For each motion of this axis, arm the limit stop</source>
        <translation>この軸の動作ごと：リミット停止を有効化</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>有効</translation>
    </message>
    <message>
        <source>The motor stops when the position error exceeds EL; this always switches the servo off.</source>
        <translation>位置偏差がELを超えるとモーターが停止します。このとき、サーボは必ずオフになります。</translation>
    </message>
    <message>
        <source>The motor stops when its current exceeds CL.</source>
        <translation>電流がCLを超えるとモーターが停止します。</translation>
    </message>
    <message>
        <source>The panel arms the limit stop whenever the motor is at rest with its servo on, even after a trip, and before any motion starts. Saved with the machine.</source>
        <translation>サーボオンでモーターが停止しているときは必ず（作動した後も）、動作を始める前に、パネルがリミット停止を有効にします。マシンとともに保存されます。</translation>
    </message>
    <message>
        <source>The limit stop is armed for each motion. Clear that check box first.</source>
        <translation>リミット停止は動作ごとに有効になります。先にそのチェックボックスを外してください。</translation>
    </message>
    <message>
        <source>A search for home or a measurement is running and uses the same function of the chip.</source>
        <translation>原点サーチまたは測定の実行中で、チップの同じ機能を使用しています。</translation>
    </message>
    <message>
        <source>○ Not armed: the search for home or the measurement has replaced it.</source>
        <translation>○ 無効：原点サーチまたは測定で解除されました。</translation>
    </message>
</context>
<context>
    <name>nmc::LinkBar</name>
    <message>
        <source>State of the link</source>
        <translation>通信の状態</translation>
    </message>
    <message>
        <source>Exchanges per second, and their share of the line&apos;s capacity.</source>
        <translation>毎秒の通信回数と、回線容量に占める割合です。</translation>
    </message>
    <message>
        <source>Failed exchanges: no answer, garbled, or refused for a bad checksum.</source>
        <translation>失敗した通信：応答なし、データ化け、またはチェックサム不良による拒否。</translation>
    </message>
    <message>
        <source>Mean time from sending a command to its complete answer.</source>
        <translation>コマンドの送信から応答の完了までの平均時間です。</translation>
    </message>
    <message>
        <source>– exchanges/s</source>
        <translation>通信 – 回/s</translation>
    </message>
    <message>
        <source>– errors</source>
        <translation>– エラー</translation>
    </message>
    <message>
        <source>round trip –</source>
        <translation>往復 –</translation>
    </message>
    <message>
        <source>%1 exchanges/s, %2 % bus load</source>
        <translation>通信 %1回/s、回線の%2%</translation>
    </message>
    <message numerus="yes">
        <source>%1 errors, %2/s</source>
        <translation>
            <numerusform>エラー%1件、%2/s</numerusform>
        </translation>
    </message>
    <message>
        <source>round trip %1 ms</source>
        <translation>往復 %1 ms</translation>
    </message>
</context>
<context>
    <name>nmc::LoopTestsDock</name>
    <message>
        <source>Square wave, frequency response (Bode plot), and a report of the tuning</source>
        <translation>矩形波、周波数応答（ボード線図）、調整結果のレポート</translation>
    </message>
    <message>
        <source>Loop tests</source>
        <translation>ループテスト</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>レポート…</translation>
    </message>
    <message>
        <source>Report: save the tuning</source>
        <translation>レポート：調整結果を保存</translation>
    </message>
    <message>
        <source>Select a PIC-SERVO first.</source>
        <translation>先にPIC-SERVOを選択してください。</translation>
    </message>
    <message>
        <source>Saves one page as PDF or HTML: gains, last step response, motor model and frequency response.</source>
        <translation>ゲイン、最後のステップ応答、モーターモデル、周波数応答を、1ページのPDFまたはHTMLとして保存します。</translation>
    </message>
</context>
<context>
    <name>nmc::MachineMenu</name>
    <message>
        <source>&amp;New machine</source>
        <translation>新しいマシン(&amp;N)</translation>
    </message>
    <message>
        <source>Discards names, units and settings of all axes; nothing is sent.</source>
        <translation>全軸の名前、単位、設定を破棄します。何も送信しません。</translation>
    </message>
    <message>
        <source>&amp;Open machine…</source>
        <translation>マシンを開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Shows what a machine file would change. Nothing is sent until you apply it.</source>
        <translation>マシンファイルで何が変わるかを表示します。適用するまで何も送信しません。</translation>
    </message>
    <message>
        <source>&amp;Save machine</source>
        <translation>マシンを保存(&amp;S)</translation>
    </message>
    <message>
        <source>Saves names, units, gains, limits, homing and groups to the machine file.</source>
        <translation>名前、単位、ゲイン、制限、原点復帰、グループをマシンファイルに保存します。</translation>
    </message>
    <message>
        <source>Save machine &amp;as…</source>
        <translation>名前を付けてマシンを保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Saves the machine under another file name.</source>
        <translation>マシンを別のファイル名で保存します。</translation>
    </message>
    <message>
        <source>Open re&amp;cent</source>
        <translation>最近使ったファイル(&amp;C)</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>最近使ったファイル</translation>
    </message>
    <message>
        <source>new machine</source>
        <translation>新しいマシン</translation>
    </message>
    <message>
        <source>Machine files (*.%1)</source>
        <translation>マシンファイル (*.%1)</translation>
    </message>
    <message>
        <source>Save machine</source>
        <translation>マシンを保存</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>マシン</translation>
    </message>
    <message>
        <source>&amp;Save and close</source>
        <translation>保存して閉じる(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Close: the changes can be restored at the next start</source>
        <translation>閉じる：次回の起動時に復元できます(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save changes</source>
        <translation>変更を保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard: the changes are lost</source>
        <translation>破棄：変更は失われます(&amp;D)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存の変更</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>キャンセル(&amp;T)</translation>
    </message>
    <message>
        <source>%1 (being saved)</source>
        <translation>%1（保存中）</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>保存中</translation>
    </message>
</context>
<context>
    <name>nmc::MainWindow</name>
    <message>
        <source>NMC Panel</source>
        <translation>NMC Panel</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>モジュール一覧</translation>
    </message>
    <message>
        <source>NMC Panel - Simulator</source>
        <translation>NMC Panel - シミュレーター</translation>
    </message>
    <message>
        <source>NMC Panel - %1</source>
        <translation>NMC Panel - %1</translation>
    </message>
    <message>
        <source>&amp;Stop and disconnect</source>
        <translation>停止して切断(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Stop and close</source>
        <translation>停止して閉じる(&amp;S)</translation>
    </message>
    <message>
        <source>Motors are moving</source>
        <translation>モーターが動いています</translation>
    </message>
    <message>
        <source>Restart the network</source>
        <translation>ネットワークを再起動</translation>
    </message>
    <message>
        <source>&amp;Restart the network: positions and gains are lost</source>
        <translation>ネットワークを再起動：位置とゲインは失われます(&amp;R)</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1（読み取り専用）</translation>
    </message>
    <message>
        <source>No module can be moved. Connect a motor module first.</source>
        <translation>動かせるモジュールがありません。先にモーターモジュールを接続してください。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Let the program &quot;%1&quot; move motors? Esc, STOP ALL or any command of yours ends that.</source>
        <translation>プログラム「%1」にモーターの操作を許可しますか？Esc、全停止、または操作者のコマンドで終了します。</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>Let it move motors</source>
        <translation>モーターの操作を許可</translation>
    </message>
</context>
<context>
    <name>nmc::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>マニュアル</translation>
    </message>
    <message>
        <source>NMC Panel - Manual</source>
        <translation>NMC Panel - マニュアル</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>マニュアルのページ一覧</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>マニュアルのページ</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Goes back to the previous page (%1).</source>
        <translation>前のページに戻ります（%1）。</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>進む</translation>
    </message>
    <message>
        <source>Goes forward again (%1).</source>
        <translation>次のページに進みます（%1）。</translation>
    </message>
    <message>
        <source>Search this page</source>
        <translation>このページを検索</translation>
    </message>
    <message>
        <source>Enter finds the next match, Shift+Enter the previous one (Ctrl+F).</source>
        <translation>Enterで次の一致、Shift+Enterで前の一致に移動します（Ctrl+F）。</translation>
    </message>
    <message>
        <source>The manual is not installed. It belongs in %1.</source>
        <translation>マニュアルがインストールされていません。所定の場所は%1です。</translation>
    </message>
    <message>
        <source>Not found on this page</source>
        <translation>このページでは見つかりません</translation>
    </message>
</context>
<context>
    <name>nmc::MessageList</name>
    <message>
        <source>No messages. Problems are listed here, with the time when they ended.</source>
        <translation>メッセージはありません。問題の発生と終了がここに表示されます。</translation>
    </message>
    <message>
        <source>No message matches the filter above.</source>
        <translation>上のフィルターに一致するメッセージがありません。</translation>
    </message>
</context>
<context>
    <name>nmc::MessagePanel</name>
    <message>
        <source>Messages and their filter</source>
        <translation>メッセージとフィルター</translation>
    </message>
    <message>
        <source>Kind of messages shown</source>
        <translation>表示するメッセージの種類</translation>
    </message>
    <message>
        <source>Filters the messages by kind.</source>
        <translation>メッセージを種類で絞り込みます。</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>Module whose messages are shown</source>
        <translation>メッセージを表示するモジュール</translation>
    </message>
    <message>
        <source>Filters the messages by module.</source>
        <translation>メッセージをモジュールで絞り込みます。</translation>
    </message>
    <message>
        <source>Active only</source>
        <translation>継続中のみ</translation>
    </message>
    <message>
        <source>Shows only messages whose cause persists.</source>
        <translation>原因が続いているメッセージだけを表示します。</translation>
    </message>
    <message>
        <source>Search messages</source>
        <translation>メッセージを検索</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Shows only messages that contain these words.</source>
        <translation>これらの語を含むメッセージだけを表示します。</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>エクスポート(&amp;X)…</translation>
    </message>
    <message>
        <source>Export the messages shown</source>
        <translation>エクスポート：表示中のメッセージ</translation>
    </message>
    <message>
        <source>Saves the messages shown to a text file.</source>
        <translation>表示中のメッセージをテキストファイルに保存します。</translation>
    </message>
    <message>
        <source>Kept for this session only.</source>
        <translation>このセッションの間だけ保持されます。</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>%1に保存</translation>
    </message>
    <message>
        <source>Export messages</source>
        <translation>メッセージのエクスポート</translation>
    </message>
</context>
<context>
    <name>nmc::MessageRow</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n回</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nmc::ModelBox</name>
    <message>
        <source>Motor model</source>
        <translation>モーターモデル</translation>
    </message>
    <message>
        <source>Find motor model</source>
        <translation>モーターモデルを同定</translation>
    </message>
    <message>
        <source>Find motor model from the steps</source>
        <translation>モーターモデルを同定：ステップから</translation>
    </message>
    <message>
        <source>Motor model found</source>
        <translation>同定したモーターモデル</translation>
    </message>
    <message>
        <source>Fill in</source>
        <translation>値を入力</translation>
    </message>
    <message>
        <source>Fill in the suggested gains</source>
        <translation>値を入力：提案ゲイン</translation>
    </message>
    <message>
        <source>Suggested gains</source>
        <translation>提案ゲイン</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>How fast the motor follows. Far right: as fast as noise, output limit and stability permit.</source>
        <translation>モーターの追従の速さです。右端：ノイズ、出力制限、安定性の許す限り速くします。</translation>
    </message>
    <message>
        <source>Damped</source>
        <translation>減衰</translation>
    </message>
    <message>
        <source>Damping. Far right: no overshoot.</source>
        <translation>減衰の強さです。右端：オーバーシュートなし。</translation>
    </message>
    <message>
        <source>Loud</source>
        <translation>騒音</translation>
    </message>
    <message>
        <source>How much encoder noise may drive the motor through Kd.</source>
        <translation>エンコーダーノイズがKdを通してモーターに及ぼしてよい影響の大きさです。</translation>
    </message>
    <message>
        <source>The motor model is being calculated.</source>
        <translation>モーターモデルを計算しています。</translation>
    </message>
    <message>
        <source>Record a step with this module first.</source>
        <translation>先にこのモジュールでステップを記録してください。</translation>
    </message>
    <message>
        <source>Calculates the motor model from up to %1 recent steps of this module. Sends nothing.</source>
        <translation>このモジュールの最近のステップ（最大%1回）からモーターモデルを計算します。何も送信しません。</translation>
    </message>
    <message>
        <source>No suggested gains. Find the motor model first.</source>
        <translation>提案ゲインがありません。先にモーターモデルを同定してください。</translation>
    </message>
    <message>
        <source>Copies the suggested gains to the Gains page. Sends nothing.</source>
        <translation>提案ゲインを「ゲイン」ページにコピーします。何も送信しません。</translation>
    </message>
    <message>
        <source>Calculating the motor model…</source>
        <translation>モーターモデルを計算中…</translation>
    </message>
    <message>
        <source>The run behind this model was removed. Find the motor model again.</source>
        <translation>このモデルの元の測定が削除されました。もう一度モーターモデルを同定してください。</translation>
    </message>
    <message>
        <source>No gains keep this motor stable and quiet.</source>
        <translation>このモーターを安定かつ静かに保てるゲインがありません。</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>位相余裕</translation>
    </message>
    <message>
        <source>The phase margin</source>
        <translation>位相余裕</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far the suggested loop is from oscillating, at least. 30°: fast, rings. 45° to 60°: moderate.</source>
        <translation>提案するループが発振までに持つ最小の余裕。30°：速いが振動が残る。45°～60°：中程度。</translation>
    </message>
    <message>
        <source>° at least</source>
        <translation>° 以上</translation>
    </message>
    <message>
        <source>Step once more and find model</source>
        <translation>もう1回動かして同定</translation>
    </message>
    <message>
        <source>Step %1 times and find model</source>
        <translation>%1回動かして同定</translation>
    </message>
    <message>
        <source>The motor jumps once more, as far as before; the model is then found from the recent steps. Make sure that everything it drives can move freely.</source>
        <translation>モーターがもう一度、これまでと同じ距離だけ急に動き、最近のステップから同定されます。駆動されるものがすべて自由に動けることを確認してください。</translation>
    </message>
    <message>
        <source>The motor jumps by the distance of the step and back, then twice as far and back, but no farther than %1 and %2 counts; the model is then found from these steps. Make sure that everything it drives can move freely.</source>
        <translation>モーターがステップの距離だけ急に動いて戻り、次にその2倍動いて戻り（ただし最大%1カウントと%2カウント）、これらのステップから同定されます。駆動されるものがすべて自由に動けることを確認してください。</translation>
    </message>
    <message>
        <source>Calculating the suggested gains…</source>
        <translation>提案ゲインを計算中…</translation>
    </message>
    <message>
        <source>The suggested gains are being calculated.</source>
        <translation>提案ゲインを計算しています。</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleBench</name>
    <message>
        <source>Simulated module controls</source>
        <translation>シミュレーションモジュールの操作</translation>
    </message>
    <message>
        <source>Pages of the simulated module</source>
        <translation>シミュレーションモジュールのページ</translation>
    </message>
    <message>
        <source>Switches</source>
        <translation>スイッチ</translation>
    </message>
    <message>
        <source>Closed while checked.</source>
        <translation>チェックすると閉じます。</translation>
    </message>
    <message>
        <source>The motor&apos;s supply, not the module&apos;s.</source>
        <translation>モジュールではなく、モーターの電源です。</translation>
    </message>
    <message>
        <source>Limit switch 1, forward</source>
        <translation>リミットスイッチ1、正方向</translation>
    </message>
    <message>
        <source>Limit switch 2, reverse</source>
        <translation>リミットスイッチ2、逆方向</translation>
    </message>
    <message>
        <source>Input 1</source>
        <translation>入力1</translation>
    </message>
    <message>
        <source>Input 2</source>
        <translation>入力2</translation>
    </message>
    <message>
        <source>The A/D reading of the temperature sensor.</source>
        <translation>温度センサーのA/D読み取り値です。</translation>
    </message>
    <message>
        <source>Limit switch 1</source>
        <translation>リミットスイッチ1</translation>
    </message>
    <message>
        <source>Limit switch 2</source>
        <translation>リミットスイッチ2</translation>
    </message>
    <message>
        <source>Encoder index</source>
        <translation>エンコーダーのインデックス</translation>
    </message>
    <message>
        <source>Stays until the shaft moves.</source>
        <translation>シャフトが動くまで保たれます。</translation>
    </message>
    <message>
        <source>Set the A/D input by hand</source>
        <translation>A/D入力を手動で設定</translation>
    </message>
    <message>
        <source>If cleared, the A/D input reads the motor current.</source>
        <translation>チェックを外すと、A/D入力はモーター電流を読み取ります。</translation>
    </message>
    <message>
        <source>ADDR line broken towards the host</source>
        <translation>ホスト側のADDR線が断線</translation>
    </message>
    <message>
        <source>The line is broken between this module and the next one towards the host, which then gets no address.</source>
        <translation>このモジュールとホスト側の隣のモジュールとの間の断線です。隣のモジュールはアドレスを得られません。</translation>
    </message>
    <message>
        <source>Power-cycle</source>
        <translation>電源入れ直し</translation>
    </message>
    <message>
        <source>Switches this module off and on: it loses its address and gains.</source>
        <translation>このモジュールの電源を入れ直します。アドレスとゲインが失われます。</translation>
    </message>
    <message>
        <source>Power-cycle all</source>
        <translation>全モジュール電源入れ直し</translation>
    </message>
    <message>
        <source>Switches all modules off and on: they lose their addresses and gains.</source>
        <translation>全モジュールの電源を入れ直します。アドレスとゲインが失われます。</translation>
    </message>
    <message>
        <source>Late tick</source>
        <translation>周期の遅れ</translation>
    </message>
    <message>
        <source>Makes one servo tick take too long: servo_overrun.</source>
        <translation>サーボ周期を1回、時間超過にします：servo_overrun。</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>機構</translation>
    </message>
    <message>
        <source>Load torque</source>
        <translation>負荷トルク</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>N·m</translation>
    </message>
    <message>
        <source>External torque; positive values turn the shaft in reverse.</source>
        <translation>外部トルクです。正の値はシャフトを逆方向に回します。</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>慣性</translation>
    </message>
    <message>
        <source>10⁻⁶ kg·m²</source>
        <translation>10⁻⁶ kg·m²</translation>
    </message>
    <message>
        <source>Moment of inertia of rotor and load.</source>
        <translation>ローターと負荷の慣性モーメントです。</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Dry friction; it also holds the shaft at rest.</source>
        <translation>乾燥摩擦です。停止中のシャフトの保持にも働きます。</translation>
    </message>
    <message>
        <source>Stop, reverse</source>
        <translation>ストッパー、逆方向</translation>
    </message>
    <message>
        <source>A hard stop at the reverse end of travel. It cannot be set past the present shaft position.</source>
        <translation>逆方向のストローク端のメカストッパーです。現在のシャフト位置を越えては設定できません。</translation>
    </message>
    <message>
        <source>Stop, forward</source>
        <translation>ストッパー、正方向</translation>
    </message>
    <message>
        <source>A hard stop at the forward end of travel. It cannot be set past the present shaft position.</source>
        <translation>正方向のストローク端のメカストッパーです。現在のシャフト位置を越えては設定できません。</translation>
    </message>
    <message>
        <source>Limit switches at the stops</source>
        <translation>ストッパー位置にリミットスイッチ</translation>
    </message>
    <message>
        <source>The limit switches close at the ends of travel and cannot be set by hand.</source>
        <translation>リミットスイッチはストローク端で閉じ、手動では設定できません。</translation>
    </message>
    <message>
        <source>Home switch at</source>
        <translation>原点スイッチの位置</translation>
    </message>
    <message>
        <source>Follows the motor&apos;s position: see Mechanics.</source>
        <translation>モーターの位置に従います。「機構」を参照してください。</translation>
    </message>
    <message>
        <source>The home switch is closed forward of this position. If cleared, set it by hand.</source>
        <translation>原点スイッチは、この位置より正方向側で閉じます。チェックを外すと、手動で設定します。</translation>
    </message>
    <message>
        <source>%1: level</source>
        <translation>%1：レベル</translation>
    </message>
    <message>
        <source>255 is 5 V.</source>
        <translation>255が5 Vに相当します。</translation>
    </message>
    <message>
        <source>PWM 1 and 2</source>
        <translation>PWM 1と2</translation>
    </message>
    <message>
        <source>The module&apos;s PWM outputs, 0 to 255.</source>
        <translation>モジュールの出力値です（/ 255）。</translation>
    </message>
    <message>
        <source>Timer or counter</source>
        <translation>タイマーまたはカウンター</translation>
    </message>
    <message>
        <source>The module&apos;s own count.</source>
        <translation>モジュールのカウント値です。</translation>
    </message>
    <message>
        <source>An output: the module sets its level.</source>
        <translation>出力です。レベルはモジュールが決めます。</translation>
    </message>
    <message>
        <source>High while checked.</source>
        <translation>チェックするとHighになります。</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1と%2</translation>
    </message>
    <message>
        <source>off, %1</source>
        <translation>オフ、%1</translation>
    </message>
    <message>
        <source>timer, %1</source>
        <translation>タイマー、%1</translation>
    </message>
    <message>
        <source>counter, %1</source>
        <translation>カウンター、%1</translation>
    </message>
</context>
<context>
    <name>nmc::ModuleContext</name>
    <message>
        <source>Waiting for the module&apos;s answer.</source>
        <translation>モジュールの応答を待っています。</translation>
    </message>
</context>
<context>
    <name>nmc::ModulePage</name>
    <message>
        <source>Motions of the selected module</source>
        <translation>選択したモジュールの動作</translation>
    </message>
    <message>
        <source>The pages of this module.</source>
        <translation>このモジュールのページです。</translation>
    </message>
</context>
<context>
    <name>nmc::ModulePanel</name>
    <message>
        <source>Selected module</source>
        <translation>選択したモジュール</translation>
    </message>
</context>
<context>
    <name>nmc::MotionBox</name>
    <message>
        <source>Ve&amp;locity</source>
        <translation>速度(&amp;L)</translation>
    </message>
    <message>
        <source>Velocity of the move</source>
        <translation>移動の速度</translation>
    </message>
    <message>
        <source>Acceleratio&amp;n</source>
        <translation>加速度(&amp;N)</translation>
    </message>
    <message>
        <source>Velocity of running</source>
        <translation>運転の速度</translation>
    </message>
    <message>
        <source>Used by every motion here, and by a smooth stop.</source>
        <translation>ここでのすべての動作と減速停止に使用します。</translation>
    </message>
    <message>
        <source>How fast the motor turns.</source>
        <translation>モーターの回る速さです。</translation>
    </message>
    <message>
        <source>Position or distance</source>
        <translation>位置または距離</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Whether the number is a position, or a distance from the present position.</source>
        <translation>数値が位置か、現在位置からの距離かを選びます。</translation>
    </message>
    <message>
        <source>&amp;Zero here</source>
        <translation>現在位置を0に(&amp;Z)</translation>
    </message>
    <message>
        <source>Load the move, start it later</source>
        <translation>ロード：移動を後で開始</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Start the loaded move</source>
        <translation>開始：ロード済みの移動</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Takes %1, peak %2: too short to reach its velocity</source>
        <translation>所要時間%1、最高%2：設定速度に達するには短すぎます</translation>
    </message>
    <message>
        <source>Takes %1, peak %2</source>
        <translation>所要時間%1、最高%2</translation>
    </message>
    <message>
        <source>Peak %1</source>
        <translation>最高%1</translation>
    </message>
    <message>
        <source>Peak %1: too short to reach its velocity</source>
        <translation>最高%1：設定速度に達するには短すぎます</translation>
    </message>
    <message>
        <source>Already there</source>
        <translation>すでにその位置です</translation>
    </message>
    <message>
        <source>The goal is outside the position range.</source>
        <translation>目標位置が位置範囲を超えています。</translation>
    </message>
    <message>
        <source>The goal of a trapezoidal move from standstill. Press Enter to start.</source>
        <translation>停止状態からの台形移動の目標位置です。Enterで開始します。</translation>
    </message>
    <message>
        <source>Go to &amp;position</source>
        <translation>位置へ移動(&amp;P)</translation>
    </message>
    <message>
        <source>Run at velocit&amp;y</source>
        <translation>運転速度(&amp;Y)</translation>
    </message>
    <message>
        <source>The velocity of a run. Press Enter to run, or to change the velocity during a run.</source>
        <translation>運転の速度です。Enterで運転を開始し、運転中は速度を変更します。</translation>
    </message>
    <message>
        <source>Loads the move without starting it. Choose Start, or start the module&apos;s group.</source>
        <translation>移動を開始せずにロードします。「開始」を選択するか、モジュールのグループを開始してください。</translation>
    </message>
    <message>
        <source>Starts the loaded move.</source>
        <translation>ロード済みの移動を開始します。</translation>
    </message>
    <message>
        <source>Moves to home.</source>
        <translation>原点へ移動します。</translation>
    </message>
    <message>
        <source>Runs forward until stopped, or to its highest position.</source>
        <translation>停止操作をするまで、または最大位置まで、正方向に運転します。</translation>
    </message>
    <message>
        <source>Runs in reverse until stopped, or to its lowest position.</source>
        <translation>停止操作をするまで、または最小位置まで、逆方向に運転します。</translation>
    </message>
</context>
<context>
    <name>nmc::MoveByBox</name>
    <message>
        <source>Step by a distance</source>
        <translation>ステップ送り：指定距離</translation>
    </message>
    <message>
        <source>Step by</source>
        <translation>ステップ送り</translation>
    </message>
    <message>
        <source>Distance of a step</source>
        <translation>ステップの距離</translation>
    </message>
    <message>
        <source>The distance of a step</source>
        <translation>ステップの距離の値</translation>
    </message>
    <message>
        <source>Step in reverse</source>
        <translation>◂| ステップ：逆方向に移動</translation>
    </message>
    <message>
        <source>Step forward</source>
        <translation>ステップ |▸：正方向に移動</translation>
    </message>
    <message>
        <source>The number of steps</source>
        <translation>ステップの回数</translation>
    </message>
    <message>
        <source>Number of steps per click.</source>
        <translation>1クリックあたりのステップの回数です。</translation>
    </message>
    <message>
        <source>The pause between steps</source>
        <translation>ステップ間の休止</translation>
    </message>
    <message>
        <source>Time to wait after each move, in seconds.</source>
        <translation>各移動の後に待つ時間（秒）です。</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>往復</translation>
    </message>
    <message>
        <source>There and back with each step</source>
        <translation>往復：各ステップ</translation>
    </message>
    <message>
        <source>Each step goes there and back.</source>
        <translation>各ステップで往復します。</translation>
    </message>
    <message>
        <source>End steps</source>
        <translation>ステップを終了</translation>
    </message>
    <message>
        <source>End steps and stop</source>
        <translation>ステップを終了：停止</translation>
    </message>
    <message>
        <source>times, pause</source>
        <translation>回、休止</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>繰り返し</translation>
    </message>
    <message>
        <source>A series of steps is already running.</source>
        <translation>連続ステップはすでに実行中です。</translation>
    </message>
    <message>
        <source>Moves forward by this distance, then holds.</source>
        <translation>この距離だけ正方向に移動し、保持します。</translation>
    </message>
    <message>
        <source>Moves in reverse by this distance, then holds.</source>
        <translation>この距離だけ逆方向に移動し、保持します。</translation>
    </message>
    <message>
        <source>No series of steps is running.</source>
        <translation>連続ステップは実行していません。</translation>
    </message>
    <message>
        <source>Ends the series of steps and stops the motor smoothly.</source>
        <translation>連続ステップを終了し、モーターを減速停止します。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Distance per click, at the velocity of Go to.</source>
        <translation>1クリックあたりの距離です。速度は「位置へ移動」と同じです。</translation>
    </message>
</context>
<context>
    <name>nmc::NumberField</name>
    <message>
        <source>%1 must be %2 to %3%4.</source>
        <translation>%1は%2～%3%4でなければなりません。</translation>
    </message>
    <message>
        <source>Enter a value for %1.</source>
        <translation>%1の値を入力してください。</translation>
    </message>
    <message>
        <source>%1 must be a number.</source>
        <translation>%1は数値でなければなりません。</translation>
    </message>
    <message>
        <source>%1 has two decimal marks. Both , and . count as decimal marks.</source>
        <translation>%1に小数点が2つあります。, と . はどちらも小数点とみなされます。</translation>
    </message>
    <message>
        <source>%1 must be a whole number without , or . in it.</source>
        <translation>%1は , や . を含まない整数でなければなりません。</translation>
    </message>
    <message>
        <source>%1: %2 can be read in two ways. Press Enter in the field for %3, or type %4.</source>
        <translation>%1：%2は2通りに読めます。%3の場合は欄でEnterを押し、そうでなければ%4と入力してください。</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorDialog</name>
    <message>
        <source>Select what the operator may do. STOP ALL, Esc, each motor&apos;s stops and Disconnect always work. Operator mode prevents mistakes; it is not a security feature: anyone with access to this computer&apos;s files can bypass it.</source>
        <translation>オペレーターに許可する操作を選択してください。全停止、Esc、各モーターの停止、切断は常に使用できます。オペレーターモードは誤操作を防ぐもので、セキュリティ機能ではありません。このコンピューターのファイルを扱える人なら回避できます。</translation>
    </message>
    <message>
        <source>&amp;Enable motors, clear faults</source>
        <translation>モーターのオンと異常のクリア(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Jog</source>
        <translation>ジョグ(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Points and sequences</source>
        <translation>ポイントとシーケンス(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Moves: go to, run, step</source>
        <translation>移動：位置へ、運転、ステップ(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Homing</source>
        <translation>原点復帰(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Outputs</source>
        <translation>出力(&amp;O)</translation>
    </message>
    <message>
        <source>P&amp;IN to leave operator mode, at least 4 characters</source>
        <translation>オペレーターモードを終了するPIN（4文字以上）(&amp;I)</translation>
    </message>
    <message>
        <source>PIN &amp;again</source>
        <translation>PINの再入力(&amp;A)</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>PIN(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Leave operator mode</source>
        <translation>オペレーターモードを終了(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Cancel: keep the mode unchanged</source>
        <translation>キャンセル：モードを変更しない</translation>
    </message>
    <message>
        <source>The PIN is too short: use at least 4 characters.</source>
        <translation>PINが短すぎます。4文字以上にしてください。</translation>
    </message>
    <message>
        <source>The two PINs differ. Type the same PIN twice.</source>
        <translation>2つのPINが異なります。同じPINを2回入力してください。</translation>
    </message>
    <message>
        <source>Wrong PIN. %1</source>
        <translation>PINが違います。%1</translation>
    </message>
    <message>
        <source>E&amp;nter operator mode</source>
        <translation>オペレーターモードを開始(&amp;N)</translation>
    </message>
</context>
<context>
    <name>nmc::OperatorLock</name>
    <message>
        <source>If you forgot it, close the panel and remove the &quot;operator&quot; section from %1.</source>
        <translation>PINを忘れた場合は、パネルを閉じ、%1から「operator」セクションを削除してください。</translation>
    </message>
    <message>
        <source>Leave o&amp;perator mode…</source>
        <translation>オペレーターモードを終了(&amp;P)…</translation>
    </message>
    <message>
        <source>O&amp;perator mode…</source>
        <translation>オペレーターモード(&amp;P)…</translation>
    </message>
    <message>
        <source>Limits the panel to the actions that you select, until someone enters the PIN.</source>
        <translation>PINが入力されるまで、選択した操作だけにパネルを制限します。</translation>
    </message>
</context>
<context>
    <name>nmc::PacketModel</name>
    <message>
        <source>Time (s)</source>
        <translation>時刻 (s)</translation>
    </message>
    <message>
        <source>Sent to</source>
        <translation>送信先</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>目的</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>意味</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>応答</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
</context>
<context>
    <name>nmc::PacketMonitor</name>
    <message>
        <source>Packet monitor</source>
        <translation>パケットモニター</translation>
    </message>
    <message>
        <source>Filter packets by module</source>
        <translation>パケットをモジュールで絞り込み</translation>
    </message>
    <message>
        <source>Shows only packets of one module (Ctrl+M).</source>
        <translation>1つのモジュールのパケットだけを表示します（Ctrl+M）。</translation>
    </message>
    <message>
        <source>Filter packets by kind</source>
        <translation>パケットを種類で絞り込み</translation>
    </message>
    <message>
        <source>Shows only packets of one kind (Ctrl+T).</source>
        <translation>1種類のパケットだけを表示します（Ctrl+T）。</translation>
    </message>
    <message>
        <source>Polls</source>
        <translation>ポーリング</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Connecting and link</source>
        <translation>接続と通信</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>エラーのみ</translation>
    </message>
    <message>
        <source>Stops recording; packets shown stay (%1).</source>
        <translation>記録を停止します。表示中のパケットは残ります（%1）。</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>Clears the packets shown (%1).</source>
        <translation>表示中のパケットを消去します（%1）。</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copies the selected rows as text, or all rows if none is selected (%1).</source>
        <translation>選択した行をテキストとしてコピーします。選択がなければ全行です（%1）。</translation>
    </message>
    <message>
        <source>Saves all recorded packets as text, or as a log that can be replayed (%1).</source>
        <translation>記録した全パケットを、テキストまたは再生可能なログとして保存します（%1）。</translation>
    </message>
    <message>
        <source>Packets and counters</source>
        <translation>パケットとカウンター</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>パケット</translation>
    </message>
    <message>
        <source>Counters</source>
        <translation>カウンター</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Save packets</source>
        <translation>パケットの保存</translation>
    </message>
    <message>
        <source>Replayable log (*%1)</source>
        <translation>再生可能なログ (*%1)</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%2件中%1件を表示</translation>
    </message>
    <message>
        <source>%1, %2 older dropped</source>
        <translation>%1、古い%2件は破棄</translation>
    </message>
    <message>
        <source>%1, paused</source>
        <translation>%1、一時停止中</translation>
    </message>
</context>
<context>
    <name>nmc::PacketView</name>
    <message>
        <source>Packets, newest last</source>
        <translation>パケット（新しいものが最後）</translation>
    </message>
    <message>
        <source>No packets. Exchanges are recorded while this view is visible.</source>
        <translation>パケットはありません。この画面を表示している間、通信が記録されます。</translation>
    </message>
    <message>
        <source>No packets match the filter.</source>
        <translation>フィルターに一致するパケットがありません。</translation>
    </message>
</context>
<context>
    <name>nmc::PanelHead</name>
    <message>
        <source>&amp;Enable servo</source>
        <translation>サーボオン(&amp;E)</translation>
    </message>
    <message>
        <source>Enable servo of this module</source>
        <translation>サーボオン：このモジュール</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Stop this module smoothly</source>
        <translation>停止：このモジュールを減速停止</translation>
    </message>
    <message>
        <source>Stop a&amp;bruptly</source>
        <translation>即停止(&amp;B)</translation>
    </message>
    <message>
        <source>Stop abruptly: this module</source>
        <translation>即停止：このモジュール</translation>
    </message>
    <message>
        <source>&amp;Motor off</source>
        <translation>モーターオフ(&amp;M)</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>位置不明</translation>
    </message>
    <message>
        <source>The servo is already on.</source>
        <translation>サーボはすでにオンです。</translation>
    </message>
    <message>
        <source>Switches the amplifier on and holds the motor in place.</source>
        <translation>アンプをオンにし、モーターをその場で保持します。</translation>
    </message>
    <message>
        <source>Slows down with the present acceleration, then holds.</source>
        <translation>現在の加速度で減速し、保持します。</translation>
    </message>
    <message>
        <source>Stops at once, then holds.</source>
        <translation>直ちに停止し、保持します。</translation>
    </message>
    <message>
        <source>&amp;Enable amplifier</source>
        <translation>アンプオン(&amp;E)</translation>
    </message>
    <message>
        <source>Enable amplifier of this module</source>
        <translation>アンプオン：このモジュール</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>ここで停止</translation>
    </message>
    <message>
        <source>Stop here: hold this module at its present position</source>
        <translation>ここで停止：このモジュールを現在位置で保持</translation>
    </message>
    <message>
        <source>Position %1 %2</source>
        <translation>位置%1 %2</translation>
    </message>
    <message>
        <source>The amplifier is already on.</source>
        <translation>アンプはすでにオンです。</translation>
    </message>
    <message>
        <source>Stops at once and switches the amplifier off: the motor is free to turn, and a load may fall.</source>
        <translation>直ちに停止し、アンプをオフにします。モーターは自由に回り、負荷が落下することがあります。</translation>
    </message>
    <message>
        <source>Task running on this module</source>
        <translation>このモジュールで実行中の処理</translation>
    </message>
    <message>
        <source>Measured velocity</source>
        <translation>測定速度</translation>
    </message>
    <message>
        <source>Velocity measured from positions over 0.2 s.</source>
        <translation>0.2秒間の位置から測定した速度です。</translation>
    </message>
    <message>
        <source>Motor power as sensed by the module.</source>
        <translation>モジュールが検出したモーター電源です。</translation>
    </message>
    <message>
        <source>Limit %1 –</source>
        <translation>リミット%1 –</translation>
    </message>
    <message>
        <source>Limit %1 high</source>
        <translation>リミット%1 High</translation>
    </message>
    <message>
        <source>Limit %1 low</source>
        <translation>リミット%1 Low</translation>
    </message>
    <message>
        <source>Power –</source>
        <translation>電源 –</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>電源</translation>
    </message>
    <message>
        <source>No power</source>
        <translation>電源なし</translation>
    </message>
    <message>
        <source>Current was limited: %1</source>
        <translation>電流が制限されました：%1</translation>
    </message>
    <message>
        <source>Current %1</source>
        <translation>電流 %1</translation>
    </message>
    <message>
        <source>● Limit stop armed</source>
        <translation>● リミット停止 有効</translation>
    </message>
    <message>
        <source>▲ Limit stop tripped</source>
        <translation>▲ リミット停止 作動</translation>
    </message>
    <message>
        <source>In motion, stops at once, as Stop abruptly does. At rest, holds the position that the motor has at this moment, without a profile.</source>
        <translation>動作中は「即停止」と同じく直ちに停止します。静止中は、この瞬間のモーターの位置を、プロファイルなしで保持します。</translation>
    </message>
    <message>
        <source>Travel limits</source>
        <translation>移動範囲</translation>
    </message>
    <message>
        <source>Switches the amplifier on, holds the motor in place and clears the sticky bits: the position error bit is set while the servo is off.</source>
        <translation>アンプをオンにしてモーターをその場で保持し、スティッキービットをクリアします。サーボがオフの間、位置偏差のビットはセットされています。</translation>
    </message>
    <message>
        <source>Looking for modules… This is the last known state.</source>
        <translation>モジュールを検索中… これは最後に報告された状態です。</translation>
    </message>
    <message>
        <source>Driven by a test</source>
        <translation>テストで駆動中</translation>
    </message>
    <message>
        <source>The test moves the motor around the position that it held.</source>
        <translation>テストは、保持していた位置のまわりでモーターを動かします。</translation>
    </message>
    <message>
        <source>Limit switch 1: high blocks the way to it.</source>
        <translation>リミットスイッチ1：Highでそこへ向かう動作を禁止。</translation>
    </message>
    <message>
        <source>Limit switch 2: high blocks the way to it.</source>
        <translation>リミットスイッチ2：Highでそこへ向かう動作を禁止。</translation>
    </message>
    <message>
        <source>counter: %1</source>
        <translation>カウンター：%1</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1：不明</translation>
    </message>
</context>
<context>
    <name>nmc::PathPlot</name>
    <message>
        <source>Positions of the path over time</source>
        <translation>パスの位置の時間推移</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>No path. Open a file, or draw one from a sequence.</source>
        <translation>パスがありません。ファイルを開くか、シーケンスから作成してください。</translation>
    </message>
</context>
<context>
    <name>nmc::PathsPage</name>
    <message>
        <source>Paths</source>
        <translation>パス</translation>
    </message>
    <message>
        <source>Choice of a path</source>
        <translation>パスの選択</translation>
    </message>
    <message>
        <source>Open path…</source>
        <translation>パスを開く…</translation>
    </message>
    <message>
        <source>Open path… from a CSV file</source>
        <translation>パスを開く…：CSVファイルから</translation>
    </message>
    <message>
        <source>Save path…</source>
        <translation>パスを保存…</translation>
    </message>
    <message>
        <source>Save path… as a CSV file</source>
        <translation>パスを保存…：CSVファイルとして</translation>
    </message>
    <message>
        <source>Sequence to draw a path from</source>
        <translation>パスの作成に使うシーケンス</translation>
    </message>
    <message>
        <source>Rate of the path to draw</source>
        <translation>作成するパスのレート</translation>
    </message>
    <message>
        <source>Draw path</source>
        <translation>パスを作成</translation>
    </message>
    <message>
        <source>Draw path from the moves of a sequence</source>
        <translation>パスを作成：シーケンスの移動から</translation>
    </message>
    <message>
        <source>The path</source>
        <translation>パスの内容</translation>
    </message>
    <message>
        <source>Running the path</source>
        <translation>パスの運転</translation>
    </message>
    <message>
        <source>Move to start</source>
        <translation>始点へ移動</translation>
    </message>
    <message>
        <source>Move to start: to the first point of the path</source>
        <translation>始点へ移動：パスの最初の点へ</translation>
    </message>
    <message>
        <source>Run path</source>
        <translation>パスを運転</translation>
    </message>
    <message>
        <source>Run path, with confirmation</source>
        <translation>パスを運転：確認の後</translation>
    </message>
    <message>
        <source>Stop path</source>
        <translation>パスを停止</translation>
    </message>
    <message>
        <source>Stop path: all its axes slow down</source>
        <translation>パスを停止：パスの全軸を減速停止</translation>
    </message>
    <message>
        <source>Progress of the path</source>
        <translation>パスの進行状況</translation>
    </message>
    <message>
        <source>State of the path</source>
        <translation>パスの状態</translation>
    </message>
    <message>
        <source>Paths need a PIC-SERVO CMC or SC. This chain has none.</source>
        <translation>パスにはPIC-SERVO CMCまたはSCが必要です。このチェーンにはありません。</translation>
    </message>
    <message>
        <source>A path is running.</source>
        <translation>パスを運転中です。</translation>
    </message>
    <message>
        <source>Open or draw a path first.</source>
        <translation>先にパスを開くか、作成してください。</translation>
    </message>
    <message>
        <source>A sequence or a move to a point is running.</source>
        <translation>シーケンスまたはポイントへの移動を運転中です。</translation>
    </message>
    <message>
        <source>The unit of an axis has changed. Open or draw the path again.</source>
        <translation>軸の単位が変わりました。パスをもう一度開くか、作成し直してください。</translation>
    </message>
    <message>
        <source>The counter or the home of an axis has changed. Draw the path again.</source>
        <translation>軸のカウンターまたは原点が変わりました。パスを作成し直してください。</translation>
    </message>
    <message>
        <source>%1 is not a path for this chain:</source>
        <translation>%1は、このチェーンのパスとして使用できません：</translation>
    </message>
    <message>
        <source>There may be more problems after these.</source>
        <translation>この後にも問題がある可能性があります。</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>ファイルを読み込み中…</translation>
    </message>
    <message>
        <source>Reads positions for each point from a CSV file. Nothing moves.</source>
        <translation>各点の位置をCSVファイルから読み込みます。何も動きません。</translation>
    </message>
    <message>
        <source>Saves the path as CSV, with its positions in the units of the axes.</source>
        <translation>パスをCSVで保存します。位置は各軸の単位で書き込みます。</translation>
    </message>
    <message>
        <source>Create a sequence of moves first (F3).</source>
        <translation>先に移動のシーケンスを作成してください（F3）。</translation>
    </message>
    <message>
        <source>Turns the moves of this sequence into one motion without stops. Nothing moves.</source>
        <translation>このシーケンスの移動を、途中で停止しない1つの動作にまとめます。何も動きません。</translation>
    </message>
    <message>
        <source>Moves each axis of the path to its first point.</source>
        <translation>パスの各軸を最初の点へ移動します。</translation>
    </message>
    <message>
        <source>Runs all axes through the path. Asks first.</source>
        <translation>確認の後、パスの全軸をパスに沿って動かします。</translation>
    </message>
    <message>
        <source>No path is running.</source>
        <translation>運転中のパスはありません。</translation>
    </message>
    <message>
        <source>Stops all axes of the path; they hold where they stop.</source>
        <translation>パスの全軸を停止します。各軸は停止した位置で保持します。</translation>
    </message>
    <message>
        <source>A path file has a column for each axis. Axes here: %1.</source>
        <translation>パスファイルには軸ごとに1列あります。ここの軸：%1。</translation>
    </message>
    <message>
        <source>Open a path</source>
        <translation>パスを開く</translation>
    </message>
    <message>
        <source>Save the path</source>
        <translation>パスの保存</translation>
    </message>
    <message>
        <source>Start of the path</source>
        <translation>パスの始点</translation>
    </message>
    <message>
        <source>All axes of the path start to move. Make sure that nothing is in their way.</source>
        <translation>パスの全軸が動き始めます。動く範囲に障害物がないことを確認してください。</translation>
    </message>
    <message>
        <source>Run the path</source>
        <translation>パスの運転</translation>
    </message>
    <message>
        <source>&amp;Run path</source>
        <translation>パスを運転(&amp;R)</translation>
    </message>
</context>
<context>
    <name>nmc::Pendant</name>
    <message>
        <source>Pendant: &amp;keyboard, gamepad or jog wheel</source>
        <translation>ペンダント：キーボード、ゲームパッド、ジョグホイール(&amp;K)</translation>
    </message>
    <message>
        <source>To move the motor, hold Shift with an arrow key, or a shoulder button of a gamepad with its left stick or D-pad, or a button of a jog wheel with its ring or wheel. B (○) of the gamepad and the middle button of the wheel are STOP ALL. (F12)</source>
        <translation>Shiftと矢印キー、ゲームパッドのショルダーボタンと左スティックまたは十字キー、あるいはジョグホイールのボタンとリングまたはホイールを操作している間、モーターが動きます。ゲームパッドのB (○) とホイールの中央のボタンは全停止です。（F12）</translation>
    </message>
</context>
<context>
    <name>nmc::PinBox</name>
    <message>
        <source>Make all pins inputs</source>
        <translation>全ピンを入力にする</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>ピン</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>Ask first</source>
        <translation>確認する</translation>
    </message>
    <message>
        <source>output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation>%1の方向</translation>
    </message>
    <message>
        <source>high: output %1</source>
        <translation>High：出力%1</translation>
    </message>
    <message>
        <source>Ask first before %1 changes</source>
        <translation>確認する：%1の変更前</translation>
    </message>
    <message>
        <source>Asks before the panel switches this output.</source>
        <translation>パネルがこの出力を切り替える前に確認します。</translation>
    </message>
    <message>
        <source>Take %1 low on STOP ALL</source>
        <translation>停止でオフ：全停止で%1をLow</translation>
    </message>
    <message>
        <source>STOP ALL takes this output low. If cleared, the output stays as it is.</source>
        <translation>全停止でこの出力をLowにします。チェックを外すと、出力はそのまま残ります。</translation>
    </message>
    <message>
        <source>Switch %1 on?</source>
        <translation>%1をオンにしますか？</translation>
    </message>
    <message>
        <source>Switch %1 off?</source>
        <translation>%1をオフにしますか？</translation>
    </message>
    <message>
        <source>&amp;Switch on</source>
        <translation>オンにする(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Switch off</source>
        <translation>オフにする(&amp;S)</translation>
    </message>
    <message>
        <source>Makes all twelve pins inputs: outputs release what they drive.</source>
        <translation>12本のピンをすべて入力にします。出力は駆動をやめます。</translation>
    </message>
    <message>
        <source>Another program set up this module, so its pin directions are unknown. Make all pins inputs to start over.</source>
        <translation>別のプログラムがこのモジュールを設定したため、ピンの方向が不明です。最初からやり直すには、全ピンを入力にしてください。</translation>
    </message>
    <message>
        <source>Pin directions unknown. Make all pins inputs first.</source>
        <translation>ピンの方向が不明です。先に全ピンを入力にしてください。</translation>
    </message>
    <message>
        <source>Input: the module reads this pin. Output: it drives this pin.</source>
        <translation>入力：モジュールがこのピンを読み取ります。出力：モジュールがこのピンを駆動します。</translation>
    </message>
    <message>
        <source>high, set low</source>
        <translation>High（設定はLow）</translation>
    </message>
    <message>
        <source>low, set high</source>
        <translation>Low（設定はHigh）</translation>
    </message>
    <message>
        <source>This pin is an input.</source>
        <translation>このピンは入力です。</translation>
    </message>
    <message>
        <source>Pin directions unknown.</source>
        <translation>ピンの方向が不明です。</translation>
    </message>
</context>
<context>
    <name>nmc::PointsModel</name>
    <message>
        <source>Point</source>
        <translation>ポイント</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
</context>
<context>
    <name>nmc::PrintDialog</name>
    <message>
        <source>&amp;Print</source>
        <translation>印刷(&amp;P)</translation>
    </message>
    <message>
        <source>Save as P&amp;DF…</source>
        <translation>PDFとして保存(&amp;D)…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>印刷</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>プリンター</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>部数</translation>
    </message>
    <message>
        <source>Printers</source>
        <translation>プリンター</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>PDFとして保存…</translation>
    </message>
    <message>
        <source>Saves the page as a file that any computer can print.</source>
        <translation>どのコンピューターでも印刷できるファイルとしてページを保存します。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>P&amp;rinter</source>
        <translation>プリンター(&amp;R)</translation>
    </message>
    <message>
        <source>C&amp;opies</source>
        <translation>部数(&amp;O)</translation>
    </message>
    <message>
        <source>The printer to use. It is preselected next time.</source>
        <translation>使用するプリンター。次回もこのプリンターが選択されます。</translation>
    </message>
    <message>
        <source>Sends the page to this printer.</source>
        <translation>このプリンターにページを送ります。</translation>
    </message>
    <message>
        <source>Save the page</source>
        <translation>ページの保存</translation>
    </message>
    <message>
        <source>page</source>
        <translation>page</translation>
    </message>
</context>
<context>
    <name>nmc::PwmBox</name>
    <message>
        <source>Drive reverse</source>
        <translation>逆方向に駆動</translation>
    </message>
    <message>
        <source>Drive forward</source>
        <translation>正方向に駆動</translation>
    </message>
    <message>
        <source>The PWM value</source>
        <translation>PWM値の設定</translation>
    </message>
    <message>
        <source>The share of the supply that drives the motor; 255 is full power.</source>
        <translation>モーターを駆動する電源の割合です。255が最大です。</translation>
    </message>
    <message>
        <source>Drive reverse with this PWM value</source>
        <translation>逆方向に駆動：このPWM値</translation>
    </message>
    <message>
        <source>Drive forward with this PWM value</source>
        <translation>正方向に駆動：このPWM値</translation>
    </message>
    <message>
        <source>PWM drives the motor directly, without the servo. No position, position error or output limit protects it, and it runs until you switch it off.</source>
        <translation>PWMはサーボを使わず、モーターを直接駆動します。位置、位置偏差、出力の制限による保護はなく、オフにするまで動き続けます。</translation>
    </message>
    <message>
        <source>= %1 %</source>
        <translation>= %1%</translation>
    </message>
    <message>
        <source>Drives the motor in reverse until you switch it off.</source>
        <translation>オフにするまで、モーターを逆方向に駆動します。</translation>
    </message>
    <message>
        <source>Drives the motor forward until you switch it off.</source>
        <translation>オフにするまで、モーターを正方向に駆動します。</translation>
    </message>
</context>
<context>
    <name>nmc::RatePage</name>
    <message>
        <source>&amp;Change baud rate</source>
        <translation>ボーレートを変更(&amp;C)</translation>
    </message>
    <message>
        <source>New baud rate of the chain</source>
        <translation>チェーンの新しいボーレート</translation>
    </message>
    <message>
        <source>The new baud rate of the whole chain.</source>
        <translation>チェーン全体の新しいボーレートです。</translation>
    </message>
    <message>
        <source>Change baud rate of the whole chain</source>
        <translation>ボーレートを変更：チェーン全体</translation>
    </message>
    <message>
        <source>%1 Bd</source>
        <translation>%1 Bd</translation>
    </message>
    <message>
        <source>Positions, gains and groups are kept. The panel checks every module at the new baud rate; if one does not answer, all modules go back to the old rate.</source>
        <translation>位置、ゲイン、グループは保たれます。パネルは全モジュールを新しいボーレートで確認し、1台でも応答しなければ、全モジュールを元のボーレートに戻します。</translation>
    </message>
    <message>
        <source>The chain runs at %1 Bd.</source>
        <translation>チェーンは%1 Bdで動作しています。</translation>
    </message>
    <message>
        <source>A motor is moving. Stop all motors to change the baud rate.</source>
        <translation>モーターが動いています。ボーレートを変更するには、すべてのモーターを停止してください。</translation>
    </message>
    <message>
        <source>The chain already runs at this baud rate.</source>
        <translation>チェーンはすでにこのボーレートです。</translation>
    </message>
    <message>
        <source>Sends the new baud rate to every module, then checks each one.</source>
        <translation>新しいボーレートを全モジュールに送信し、1台ずつ確認します。</translation>
    </message>
    <message>
        <source>Modules that do not answer would stay at the old baud rate: %1.</source>
        <translation>応答しないモジュールは元のボーレートに取り残されます：%1。</translation>
    </message>
    <message>
        <source>Modules with an unknown group may miss the change: %1. Set their group on the Groups page, or none.</source>
        <translation>グループが不明なモジュールには、変更が伝わらないことがあります：%1。「グループ」ページでグループを設定するか、「なし」にしてください。</translation>
    </message>
    <message>
        <source>Group leaders would answer during the change. Make these ordinary members on the Groups page: %1.</source>
        <translation>グループリーダーは変更中に応答してしまいます。「グループ」ページで通常のメンバーにしてください：%1。</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>その他…</translation>
    </message>
    <message>
        <source>Divisor of Set Baud Rate</source>
        <translation>Set Baud Rateの除数</translation>
    </message>
    <message>
        <source>The baud rate is 1 250 000 Bd / (divisor + 1). The panel first checks that this computer&apos;s port supports it to within 2 %.</source>
        <translation>ボーレートは1 250 000 Bd / (除数 + 1) です。パネルはまず、このコンピューターのポートが2%以内の誤差で対応しているかを確認します。</translation>
    </message>
    <message>
        <source>= %1 Bd</source>
        <translation>= %1 Bd</translation>
    </message>
    <message>
        <source>The divisor</source>
        <translation>分周値</translation>
    </message>
</context>
<context>
    <name>nmc::RepeatabilityBox</name>
    <message>
        <source>Repeatability and backlash</source>
        <translation>繰り返し精度とバックラッシ</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Measure repeatability and backlash</source>
        <translation>繰り返し精度とバックラッシを測定</translation>
    </message>
    <message>
        <source>Cancel measuring the repeatability</source>
        <translation>繰り返し精度の測定を中止</translation>
    </message>
    <message>
        <source>Use as backlash</source>
        <translation>バックラッシとして使用</translation>
    </message>
    <message>
        <source>Use as backlash of the axis</source>
        <translation>軸のバックラッシとして使用</translation>
    </message>
    <message>
        <source>Result of the repeatability measurement</source>
        <translation>繰り返し精度測定の結果</translation>
    </message>
    <message>
        <source>Approach this input</source>
        <translation>この入力に接近</translation>
    </message>
    <message>
        <source>The motor approaches it from both sides. Direction, acceleration, search distance and time limit are those of the search for home.</source>
        <translation>モーターが両側から接近します。方向、加速度、サーチ距離、制限時間は原点サーチのものを使います。</translation>
    </message>
    <message>
        <source>Velocity of the approach</source>
        <translation>接近速度</translation>
    </message>
    <message>
        <source>Slower is more exact: the chip may read its inputs only once per servo tick.</source>
        <translation>遅いほど正確です。チップが入力を見るのはサーボ周期ごとに1回だけかもしれません。</translation>
    </message>
    <message>
        <source>Times from each side</source>
        <translation>各側からの回数</translation>
    </message>
    <message>
        <source>Number of approaches from each side.</source>
        <translation>各側から接近する回数です。</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>接近先</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>回数</translation>
    </message>
    <message>
        <source>from each side</source>
        <translation>各側から</translation>
    </message>
    <message>
        <source>The measurement is running.</source>
        <translation>測定中です。</translation>
    </message>
    <message>
        <source>Measure first.</source>
        <translation>先に測定してください。</translation>
    </message>
    <message>
        <source>An index does not show the backlash of the load.</source>
        <translation>インデックスからは負荷のバックラッシは分かりません。</translation>
    </message>
    <message>
        <source>No backlash was found that exceeds its uncertainty.</source>
        <translation>不確かさを超えるバックラッシは見つかりませんでした。</translation>
    </message>
    <message>
        <source>The axis has this backlash.</source>
        <translation>軸にはこのバックラッシが設定済みです。</translation>
    </message>
    <message>
        <source>Not measured in this connection.</source>
        <translation>この接続では未測定です。</translation>
    </message>
    <message>
        <source>Forward, %4 times: mean %1, standard deviation %2, range %3</source>
        <translation>正方向、%4回：平均 %1、標準偏差 %2、範囲 %3</translation>
    </message>
    <message>
        <source>Reverse, %4 times: mean %1, standard deviation %2, range %3</source>
        <translation>逆方向、%4回：平均 %1、標準偏差 %2、範囲 %3</translation>
    </message>
    <message>
        <source>Difference: %1 ± %2</source>
        <translation>差：%1 ± %2</translation>
    </message>
    <message>
        <source>Backlash: %1 ± %2</source>
        <translation>バックラッシ：%1 ± %2</translation>
    </message>
    <message>
        <source>The index is on the encoder&apos;s own shaft: this shows how well a capture repeats, not the backlash of the load.</source>
        <translation>インデックスはエンコーダー自身の軸にあります。これは捕捉の繰り返し精度を示すもので、負荷のバックラッシではありません。</translation>
    </message>
    <message>
        <source>Below zero, so this is not backlash. The switch may bounce.</source>
        <translation>負の値なのでバックラッシではありません。スイッチがチャタリングしている可能性があります。</translation>
    </message>
    <message>
        <source>Includes the hysteresis of the switch itself. Only with the encoder on the motor and the switch on the load does it show the backlash between them.</source>
        <translation>スイッチ自身のヒステリシスを含みます。エンコーダーがモーター側、スイッチが負荷側にある場合にのみ、その間のバックラッシを示します。</translation>
    </message>
    <message>
        <source>The motor moves up to %1 between two readings of the inputs. Measure more slowly.</source>
        <translation>チップが入力を見る間にモーターは最大%1動きます。もっと遅く測定してください。</translation>
    </message>
    <message>
        <source>Moves the motor to and fro across the switch or index, and reads where it was captured.</source>
        <translation>スイッチまたはインデックスを往復させ、捕捉された位置を読み取ります。</translation>
    </message>
    <message>
        <source>No measurement is running.</source>
        <translation>測定は実行されていません。</translation>
    </message>
    <message>
        <source>Stops the motor smoothly; what was captured stays.</source>
        <translation>モーターを滑らかに停止します。捕捉した値は残ります。</translation>
    </message>
    <message>
        <source>Makes %1 the backlash of the axis (Axis page): what was measured, with its uncertainty. Sends nothing.</source>
        <translation>%1を軸のバックラッシにします（軸ページ）：測定値に不確かさを加えた値です。何も送信しません。</translation>
    </message>
</context>
<context>
    <name>nmc::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>問題を報告</translation>
    </message>
    <message>
        <source>Nothing is sent. Read the report below, save it, and attach the file where you describe the problem. It contains neither your PIN nor the name of your home folder.</source>
        <translation>何も送信しません。下のレポートを確認して保存し、問題を説明する場所にそのファイルを添付してください。レポートには、PINもホームフォルダーの名前も含まれません。</translation>
    </message>
    <message>
        <source>Text of the report</source>
        <translation>レポートの本文</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>名前を付けて保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>レポートの保存</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseForm</name>
    <message>
        <source>Settings of the next step</source>
        <translation>次のステップの設定</translation>
    </message>
    <message>
        <source>Distance of the step response</source>
        <translation>ステップ応答の距離</translation>
    </message>
    <message>
        <source>The distance of the step</source>
        <translation>ステップ応答の距離の値</translation>
    </message>
    <message>
        <source>The record</source>
        <translation>記録時間の値</translation>
    </message>
    <message>
        <source>The settling band</source>
        <translation>整定幅の値</translation>
    </message>
    <message>
        <source>% of the step</source>
        <translation>ステップの%</translation>
    </message>
    <message>
        <source>The motor has settled when it stays this close to its goal. At least one count. Applies to all runs.</source>
        <translation>モーターが目標位置からこの範囲内に留まると、整定したとみなします。最小1カウント。すべての測定に適用されます。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Settling band</source>
        <translation>整定幅</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Step and record</source>
        <translation>ステップ：実行して記録</translation>
    </message>
    <message>
        <source>The motor jumps by this distance, then holds. Make sure that everything it drives can move freely (Shift+F9).</source>
        <translation>モーターがこの距離だけ急に動き、保持します。駆動されるものがすべて自由に動けることを確認してください（Shift+F9）。</translation>
    </message>
    <message>
        <source>%1 %2 instead of %3</source>
        <translation>%1 %2（現在は%3）</translation>
    </message>
    <message>
        <source>Some gains in the fields were not sent: %1. Which gains should the step use?</source>
        <translation>欄に未送信のゲインがあります：%1。どちらのゲインでステップを実行しますか？</translation>
    </message>
    <message>
        <source>Gains not sent</source>
        <translation>未送信のゲイン</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Apply and step</source>
        <translation>適用してステップ(&amp;A)</translation>
    </message>
    <message>
        <source>Step with &amp;present gains</source>
        <translation>現在のゲインでステップ(&amp;P)</translation>
    </message>
    <message>
        <source>How far the command goes; negative: reverse. Small steps show the tuning of the servo, large ones the limits of the amplifier.</source>
        <translation>指令の移動量です。負: 逆方向。小さいステップはサーボの調整を、大きいステップはアンプの限界を示します。</translation>
    </message>
    <message>
        <source>How long to record after the step, or after the end of a move. Then the motor is commanded to hold.</source>
        <translation>ステップ後または移動終了後に記録する時間です。その後モーターは保持されます。</translation>
    </message>
    <message>
        <source>Velocity of the move</source>
        <translation>移動の速度</translation>
    </message>
    <message>
        <source>Acceleration of the move</source>
        <translation>移動の加速度</translation>
    </message>
    <message>
        <source>Moves there and back</source>
        <translation>往復移動</translation>
    </message>
    <message>
        <source>How often it moves there and back. Each move is recorded.</source>
        <translation>往復の回数です。各移動を記録します。</translation>
    </message>
    <message>
        <source>Settling window</source>
        <translation>整定幅</translation>
    </message>
    <message>
        <source>The motor has settled when it stays this close to its goal for the dwell. At least one count. Applies to all moves.</source>
        <translation>保持時間の間、目標からこの範囲にとどまると整定とみなします。最小 1 カウント。すべての移動に適用されます。</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>保持時間</translation>
    </message>
    <message>
        <source>How long it must stay in the window. The settling time ends where the dwell begins.</source>
        <translation>整定幅の中にとどまるべき時間です。整定時間は保持時間の始まりで終わります。</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>整定幅</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>往復</translation>
    </message>
    <message>
        <source>A step or move is already running.</source>
        <translation>ステップまたは移動がすでに実行中です。</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Move and record</source>
        <translation>移動して記録</translation>
    </message>
    <message>
        <source>The motor moves there and back, then holds. Make sure that everything it drives can move freely (Shift+F9).</source>
        <translation>モーターは往復してから保持します。駆動されるすべてのものが自由に動けることを確認してください (Shift+F9)。</translation>
    </message>
    <message>
        <source>The velocity of the move. Until you type one, it is that of moves to a position.</source>
        <translation>移動の速度です。入力するまでは、位置への移動の速度です。</translation>
    </message>
    <message>
        <source>The acceleration of the move. Until you type one, it is that of moves to a position.</source>
        <translation>移動の加速度です。入力するまでは、位置への移動の加速度です。</translation>
    </message>
</context>
<context>
    <name>nmc::ResponsePage</name>
    <message>
        <source>Use these gains</source>
        <translation>このゲインを使用</translation>
    </message>
    <message>
        <source>Select a run in the list first.</source>
        <translation>先に一覧で測定を選択してください。</translation>
    </message>
    <message>
        <source>This run belongs to %1. Select that module first.</source>
        <translation>この測定は%1のものです。先にそのモジュールを選択してください。</translation>
    </message>
    <message>
        <source>Copies the gains of this run to the Gains page. Sends nothing (Ctrl+Shift+U).</source>
        <translation>この測定のゲインを「ゲイン」ページにコピーします。何も送信しません（Ctrl+Shift+U）。</translation>
    </message>
    <message>
        <source>Removes this run from the list (Ctrl+Del).</source>
        <translation>この測定を一覧から削除します（Ctrl+Del）。</translation>
    </message>
    <message>
        <source>No run yet. Record a step first.</source>
        <translation>測定がありません。先にステップを記録してください。</translation>
    </message>
    <message>
        <source>Saves all runs in the list with their gains and results (Ctrl+Shift+X).</source>
        <translation>一覧のすべての測定を、ゲインと結果とともに保存します（Ctrl+Shift+X）。</translation>
    </message>
    <message>
        <source>Export step responses</source>
        <translation>ステップ応答のエクスポート</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Step results</source>
        <translation>ステップの結果</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>すべての測定</translation>
    </message>
    <message>
        <source>All runs of this module in the plot</source>
        <translation>すべての測定：このモジュールの測定をグラフに表示</translation>
    </message>
    <message>
        <source>Shows the other runs of this module, older runs paler.</source>
        <translation>このモジュールのほかの測定を、古いものほど淡く表示します。</translation>
    </message>
    <message>
        <source>No run was removed.</source>
        <translation>削除した測定はありません。</translation>
    </message>
    <message>
        <source>Restores the run removed last (Ctrl+Shift+Del).</source>
        <translation>最後に削除した測定を復元します（Ctrl+Shift+Del）。</translation>
    </message>
</context>
<context>
    <name>nmc::ResponsePlot</name>
    <message>
        <source>Step responses over time</source>
        <translation>ステップ応答の推移</translation>
    </message>
    <message>
        <source>run %1, %2</source>
        <translation>測定%1、%2</translation>
    </message>
    <message>
        <source>A: %1</source>
        <translation>A：%1</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B：%1</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>No run selected. A step response shows how the motor follows a jump of its command.</source>
        <translation>測定が選択されていません。ステップ応答は、指令の急変にモーターがどう追従するかを示します。</translation>
    </message>
    <message>
        <source>motor model</source>
        <translation>モーターモデル</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>Positions since the step, relative to its start. The shaded band is the settling band around the goal. Double-click to switch between the whole record and the motion. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time.</source>
        <translation>ステップ開始時を基準にした、ステップ後の位置です。網掛けの帯は、目標位置を中心とした整定幅です。ダブルクリックで、記録全体と動作部分の表示を切り替えます。スクロールで時間を、Ctrlを押しながらで位置を拡大縮小し、ドラッグで表示を移動し、Shiftを押しながらドラッグして時間を選択します。</translation>
    </message>
    <message>
        <source>time since the step (s)</source>
        <translation>ステップからの時間 (s)</translation>
    </message>
    <message>
        <source>position from the start</source>
        <translation>開始点からの位置</translation>
    </message>
    <message>
        <source>position from the start (%1)</source>
        <translation>開始点からの位置 (%1)</translation>
    </message>
    <message>
        <source>goal, command</source>
        <translation>目標、指令</translation>
    </message>
    <message>
        <source>time since the start (s)</source>
        <translation>開始からの時間 (s)</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseResults</name>
    <message>
        <source>Results of the runs shown</source>
        <translation>表示中の測定の結果</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>立ち上がり（10～90%）</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>定常偏差</translation>
    </message>
    <message>
        <source>Peak PWM, of 255</source>
        <translation>最大PWM（/ 255）</translation>
    </message>
    <message>
        <source>Sample interval</source>
        <translation>サンプル間隔</translation>
    </message>
    <message>
        <source>Time from 10 % to 90 % of the step.</source>
        <translation>ステップの10%から90%までの時間です。</translation>
    </message>
    <message>
        <source>How far the motor went past its goal, in % of the step.</source>
        <translation>モーターが目標位置を行き過ぎた量です（ステップに対する%）。</translation>
    </message>
    <message>
        <source>Goal minus the mean position over the last fifth of the record.</source>
        <translation>目標位置から、記録の最後の5分の1の平均位置を引いた値です。</translation>
    </message>
    <message>
        <source>PWM demand at the jump, calculated from the gains. Later ticks may need more: below the output limit OL this is a lower bound.</source>
        <translation>指令の急変時に必要なPWMを、ゲインから計算した値です。以降の周期でさらに必要になることがあります。出力制限OL未満の場合、この値は下限です。</translation>
    </message>
    <message>
        <source>Mean time between two positions of the record. It sets the accuracy of the results.</source>
        <translation>記録の2つの位置の間の平均時間です。結果の精度を左右します。</translation>
    </message>
    <message>
        <source>Settling to the goal</source>
        <translation>目標位置への整定</translation>
    </message>
    <message>
        <source>Settling to rest position</source>
        <translation>静止位置への整定</translation>
    </message>
    <message>
        <source>Time until the position stays within the settling band around the goal. Empty if that happens only in the last fifth of the record.</source>
        <translation>位置が目標位置の整定幅内に留まるまでの時間です。記録の最後の5分の1で初めてそうなった場合は空欄です。</translation>
    </message>
    <message>
        <source>Time until the position stays within the settling band around the mean position of the last fifth of the record. Without integral gain (Ki, IL), friction holds a motor off its goal.</source>
        <translation>同じく、記録の最後の5分の1の平均位置を中心とした値です。積分ゲイン（Ki、IL）がないと、摩擦によりモーターが目標位置からずれて止まります。</translation>
    </message>
    <message>
        <source>Move time</source>
        <translation>移動時間</translation>
    </message>
    <message>
        <source>Settling after the move</source>
        <translation>移動後の整定</translation>
    </message>
    <message>
        <source>Settling, all moves</source>
        <translation>整定、全移動</translation>
    </message>
    <message>
        <source>Peak error</source>
        <translation>最大偏差</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>偏差の実効値</translation>
    </message>
    <message>
        <source>Error at constant velocity</source>
        <translation>一定速度での偏差</translation>
    </message>
    <message>
        <source>Duration of the commanded profile, calculated from distance, velocity and acceleration.</source>
        <translation>距離、速度、加速度から計算した指令プロファイルの時間です。</translation>
    </message>
    <message>
        <source>Time from the end of the profile until the motor is in the window, where it stays for the dwell.</source>
        <translation>プロファイルの終わりから、モーターが整定幅に入り保持時間とどまるまでの時間です。</translation>
    </message>
    <message>
        <source>The shortest and the longest settling time of the moves there and back, and their number.</source>
        <translation>往復移動の最短と最長の整定時間、およびその回数です。</translation>
    </message>
    <message>
        <source>The largest position error during the move and after it, without its sign.</source>
        <translation>移動中および移動後の最大の位置偏差 (符号なし) です。</translation>
    </message>
    <message>
        <source>Root mean square of the position error during the move.</source>
        <translation>移動中の位置偏差の二乗平均平方根です。</translation>
    </message>
    <message>
        <source>Mean position error over the second half of the time at constant velocity.</source>
        <translation>一定速度の時間の後半における位置偏差の平均です。</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseTable</name>
    <message>
        <source>Step responses so far</source>
        <translation>これまでのステップ応答</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>Run %1 as A</source>
        <translation>測定%1をAに</translation>
    </message>
    <message>
        <source>Run %1 as B</source>
        <translation>測定%1をBに</translation>
    </message>
    <message>
        <source>Draws this run as A, with a solid line.</source>
        <translation>この測定をAとして実線で描きます。</translation>
    </message>
    <message>
        <source>Draws this run as B, with a dashed line.</source>
        <translation>この測定をBとして破線で描きます。</translation>
    </message>
    <message>
        <source>Step responses, newest first. Select two check boxes to compare the curves. The last %1 are saved with the machine; those with a name or a note are kept longest.</source>
        <translation>ステップ応答（新しいものが先頭）です。チェックボックスを2つ選択すると、曲線を比較できます。最後の%1件はマシンとともに保存され、名前または注記のあるものは最も長く残ります。</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>Name of the run. Double-click or press F2 to edit.</source>
        <translation>測定の名前です。ダブルクリックまたはF2で編集します。</translation>
    </message>
    <message>
        <source>Note on the run. Double-click or press F2 to edit.</source>
        <translation>測定の注記です。ダブルクリックまたはF2で編集します。</translation>
    </message>
</context>
<context>
    <name>nmc::ResponseView</name>
    <message>
        <source>Run</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体表示</translation>
    </message>
    <message>
        <source>Fits the view to the motion and all positions (A, in the plot).</source>
        <translation>動作の時間とすべての位置が収まるように表示します（グラフでA）。</translation>
    </message>
    <message>
        <source>Shows two cursors to measure with: drag them (C, in the plot).</source>
        <translation>測定用の2本のカーソルを表示します：ドラッグして動かします（グラフでC）。</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Copies the visible plot to the clipboard.</source>
        <translation>表示中のグラフをクリップボードにコピーします。</translation>
    </message>
    <message>
        <source>Exports the visible plot, with a description of the runs.</source>
        <translation>表示中のグラフを、測定の説明とともにエクスポートします。</translation>
    </message>
    <message>
        <source>A: run %1, %2, %3, %4</source>
        <translation>A：測定%1、%2、%3、%4</translation>
    </message>
    <message>
        <source>B: run %1, %2, %3, %4</source>
        <translation>B：測定%1、%2、%3、%4</translation>
    </message>
    <message>
        <source>Kp %1 Kd %2 Ki %3 IL %4; rise %5; overshoot %6; settling %7</source>
        <translation>Kp %1 Kd %2 Ki %3 IL %4、立ち上がり %5、オーバーシュート %6、整定 %7</translation>
    </message>
    <message>
        <source>Step response, by NMC Panel %1</source>
        <translation>ステップ応答、NMC Panel %1</translation>
    </message>
    <message>
        <source>%1: cursor 1 %2, cursor 2 %3, difference %4</source>
        <translation>%1：カーソル1 %2、カーソル2 %3、差 %4</translation>
    </message>
    <message>
        <source>Picture of the step response</source>
        <translation>ステップ応答の画像</translation>
    </message>
    <message>
        <source>step</source>
        <translation>ステップ応答</translation>
    </message>
</context>
<context>
    <name>nmc::Ribbons</name>
    <message>
        <source>SIMULATOR — no hardware connected; all values are simulated</source>
        <translation>シミュレーター — ハードウェアは未接続。すべてシミュレーション値です</translation>
    </message>
    <message>
        <source>Simulated session</source>
        <translation>シミュレーションセッション</translation>
    </message>
    <message>
        <source>Read-only session</source>
        <translation>読み取り専用セッション</translation>
    </message>
    <message>
        <source>READ-ONLY — only status requests are sent. STOP ALL still works.</source>
        <translation>読み取り専用 — ステータス要求だけを送信します。全停止は使用できます。</translation>
    </message>
    <message>
        <source>Reconnects to the same port with commands allowed. Nothing moves.</source>
        <translation>コマンドを許可して、同じポートに再接続します。何も動きません。</translation>
    </message>
    <message>
        <source>OPERATOR MODE — only allowed actions are available. STOP ALL always works.</source>
        <translation>オペレーターモード — 許可された操作だけを使用できます。全停止は常に使用できます。</translation>
    </message>
    <message>
        <source>Leave…</source>
        <translation>モード終了…</translation>
    </message>
    <message>
        <source>End pendant mode</source>
        <translation>ペンダントモードを終了</translation>
    </message>
    <message>
        <source>Hold Shift with ◂ or ▸ to move it. Esc ends pendant mode.</source>
        <translation>Shiftと◂または▸を押している間、動きます。Escでペンダントモードを終了します。</translation>
    </message>
    <message>
        <source>Not moved: %1</source>
        <translation>動かしていません：%1</translation>
    </message>
    <message>
        <source>PENDANT — %1. %2</source>
        <translation>ペンダント — %1。%2</translation>
    </message>
    <message>
        <source>Pendant</source>
        <translation>ペンダント</translation>
    </message>
    <message>
        <source>Ends pendant mode: arrow keys and gamepad no longer move anything.</source>
        <translation>ペンダントモードを終了します。矢印キーとゲームパッドでは何も動かなくなります。</translation>
    </message>
    <message>
        <source>To move it, hold Shift with ◂ or ▸, or a shoulder button of the gamepad with its left stick or D-pad. B (○) is STOP ALL. Esc ends pendant mode.</source>
        <translation>Shiftと◂または▸、あるいはゲームパッドのショルダーボタンと左スティックまたは十字キーを押している間、動きます。B (○) は全停止です。Escでペンダントモードを終了します。</translation>
    </message>
    <message>
        <source>End control</source>
        <translation>操作権を終了</translation>
    </message>
    <message>
        <source>The program may no longer move motors.</source>
        <translation>このプログラムはモーターを動かせなくなります。</translation>
    </message>
    <message>
        <source>PROGRAM — &quot;%1&quot; may move motors. Esc or any command of yours ends that.</source>
        <translation>プログラム — 「%1」はモーターを動かせます。Escまたは操作者のコマンドで終了します。</translation>
    </message>
    <message>
        <source>PROGRAMS — none can connect now.</source>
        <translation>プログラム — 現在は接続できません。</translation>
    </message>
    <message>
        <source>PROGRAMS — may connect once a port is open.</source>
        <translation>プログラム — ポートを開くと接続できます。</translation>
    </message>
    <message>
        <source>PROGRAMS — may connect at %1. Connected: %2.</source>
        <translation>プログラム — %1で接続できます。接続数：%2。</translation>
    </message>
    <message>
        <source>Line lent to a program</source>
        <translation>プログラムに貸した回線</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>続行させる</translation>
    </message>
    <message>
        <source>The program has the line again. It may move motors at once.</source>
        <translation>プログラムが再び回線を使用します。すぐにモーターを動かすことがあります。</translation>
    </message>
    <message>
        <source>End lending</source>
        <translation>貸出を終了</translation>
    </message>
    <message>
        <source>The program loses the line, and the chain is scanned again. Nothing is reset or stopped.</source>
        <translation>プログラムは回線を失い、モジュールを改めて調べます。リセットも停止もしません。</translation>
    </message>
    <message>
        <source>There is a jog wheel, but you may not read it. Unplug it and plug it in again; if that does not help, see the manual. Esc ends pendant mode.</source>
        <translation>ジョグホイールが接続されていますが、読み取る権限がありません。一度抜いて差し直してください。それでも使えない場合はマニュアルを参照してください。Escでペンダントモードを終了します。</translation>
    </message>
    <message>
        <source>To move it, hold a button of the jog wheel, and push its ring or cap for a speed or turn the wheel for steps. The middle button, or the right one of a 3-axis mouse, is STOP ALL. Esc ends pendant mode.</source>
        <translation>ジョグホイールのボタンを押しながら、リングまたはキャップを倒すと速度で、ホイールを回すとステップで動きます。中央のボタン（3軸マウスでは右ボタン）は全停止です。Escでペンダントモードを終了します。</translation>
    </message>
</context>
<context>
    <name>nmc::RowDelegate</name>
    <message>
        <source>Value of the row</source>
        <translation>行の値</translation>
    </message>
    <message>
        <source>The value</source>
        <translation>値の入力</translation>
    </message>
    <message>
        <source>Choices of the row</source>
        <translation>行の選択肢</translation>
    </message>
</context>
<context>
    <name>nmc::RowsModel</name>
    <message>
        <source>from row %1 on</source>
        <translation>%1行目から</translation>
    </message>
    <message>
        <source>together</source>
        <translation>同時</translation>
    </message>
    <message>
        <source>together, next row at once</source>
        <translation>同時、すぐ次の行へ</translation>
    </message>
    <message>
        <source>one after the other</source>
        <translation>順番に</translation>
    </message>
    <message>
        <source>one after the other, next row at once</source>
        <translation>順番に、すぐ次の行へ</translation>
    </message>
    <message>
        <source>%1 active</source>
        <translation>%1がオン</translation>
    </message>
    <message>
        <source>%1 not active</source>
        <translation>%1がオフ</translation>
    </message>
    <message>
        <source>output %1 on</source>
        <translation>出力%1をオン</translation>
    </message>
    <message>
        <source>output %1 off</source>
        <translation>出力%1をオフ</translation>
    </message>
    <message>
        <source>%1 % of its velocity</source>
        <translation>速度の%1%</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>within %1 s</source>
        <translation>%1 s以内</translation>
    </message>
    <message>
        <source>forever</source>
        <translation>無限</translation>
    </message>
    <message numerus="yes">
        <source>%n times in all</source>
        <translation>
            <numerusform>全%n回</numerusform>
        </translation>
    </message>
    <message>
        <source>Action</source>
        <translation>実行内容</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>%1がHigh</translation>
    </message>
    <message>
        <source>%1 low</source>
        <translation>%1がLow</translation>
    </message>
    <message>
        <source>IO%1 high</source>
        <translation>IO%1をHigh</translation>
    </message>
    <message>
        <source>IO%1 low</source>
        <translation>IO%1をLow</translation>
    </message>
    <message>
        <source>A/D %1 above</source>
        <translation>A/D %1が上回る</translation>
    </message>
    <message>
        <source>A/D %1 below</source>
        <translation>A/D %1が下回る</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>制限時間</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeBar</name>
    <message>
        <source>Freezes the display (Ctrl+P). Recording of samples continues.</source>
        <translation>表示を固定します（Ctrl+P）。サンプルの記録は続きます。</translation>
    </message>
    <message>
        <source>Shows two cursors to measure with: drag them (C).</source>
        <translation>測定用の2本のカーソルを表示します：ドラッグして動かします（C）。</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>ステータスビット</translation>
    </message>
    <message>
        <source>Shows the status bits of the selected module over time (B).</source>
        <translation>選択したモジュールのステータスビットの推移を表示します（B）。</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Time shown by the scope</source>
        <translation>スコープの表示時間</translation>
    </message>
    <message>
        <source>Sets how much time the scope shows.</source>
        <translation>スコープに表示する時間の長さを設定します。</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>表示時間(&amp;W)</translation>
    </message>
    <message>
        <source>Signals…</source>
        <translation>信号…</translation>
    </message>
    <message>
        <source>Selects signals for the strips (S).</source>
        <translation>表示欄に表示する信号を選択します（S）。</translation>
    </message>
    <message>
        <source>Waits for a signal or a status bit, and holds the picture around it (T).</source>
        <translation>信号またはステータスビットを待ち、その前後の画面を保持します（T）。</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>ライブに戻る</translation>
    </message>
    <message>
        <source>Returns to the live display.</source>
        <translation>ライブ表示に戻ります。</translation>
    </message>
    <message>
        <source>Source of the picture</source>
        <translation>画面の表示元</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeExport</name>
    <message>
        <source>Export</source>
        <translation>エクスポート</translation>
    </message>
    <message>
        <source>&amp;Samples (CSV)…</source>
        <translation>サンプル (CSV)(&amp;S)…</translation>
    </message>
    <message>
        <source>Copies the visible plot to the clipboard, with its samples if there are only a few.</source>
        <translation>表示中のグラフをクリップボードにコピーします。サンプルが少なければ一緒にコピーします。</translation>
    </message>
    <message>
        <source>Export from the scope</source>
        <translation>スコープからエクスポート</translation>
    </message>
    <message>
        <source>scope</source>
        <translation>スコープ</translation>
    </message>
    <message>
        <source>All samples of all modules in the visible time. A file with one row per reply can be reopened here; one with a column per signal is for other programs only.</source>
        <translation>表示時間内の全モジュールの全サンプルです。応答ごとに1行のファイルはここで開き直せます。信号ごとに1列のファイルは、ほかのプログラム専用です。</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeFiles</name>
    <message>
        <source>Open &amp;recording…</source>
        <translation>記録を開く(&amp;R)…</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>記録一覧</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>記録を停止</translation>
    </message>
    <message>
        <source>Ends the recording and closes its file (Ctrl+Shift+R).</source>
        <translation>記録を終了し、ファイルを閉じます（Ctrl+Shift+R）。</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>読み込み中</translation>
    </message>
    <message>
        <source>Cancels opening; the scope stays as it is.</source>
        <translation>読み込みを中止します。スコープはそのままです。</translation>
    </message>
    <message>
        <source>Shows a recording in the scope. Control of the motors continues.</source>
        <translation>記録をスコープに表示します。モーターの制御は続きます。</translation>
    </message>
    <message>
        <source>Saves every sample of all modules to a file from now on (Ctrl+Shift+R).</source>
        <translation>これ以降の全モジュールの全サンプルをファイルに保存します（Ctrl+Shift+R）。</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>記録…</translation>
    </message>
    <message>
        <source>Nothing to record: connect a module first.</source>
        <translation>記録するものがありません。先にモジュールを接続してください。</translation>
    </message>
    <message>
        <source>● Recording %1, %2, %3</source>
        <translation>● 記録中 %1、%2、%3</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Opening %1, %2 %</source>
        <translation>%1を読み込み中、%2%</translation>
    </message>
    <message>
        <source>Record to a file</source>
        <translation>ファイルに記録</translation>
    </message>
    <message>
        <source>Recordings (*.%1)</source>
        <translation>記録 (*.%1)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Over&amp;lay a recording…</source>
        <translation>記録を重ね表示(&amp;L)…</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>重ね表示</translation>
    </message>
    <message>
        <source>Removes the recording from the plots. Its file is kept.</source>
        <translation>グラフから記録を外します。ファイルは残ります。</translation>
    </message>
    <message>
        <source>◂ Earlier</source>
        <translation>◂ 前へ</translation>
    </message>
    <message>
        <source>Moves the recording to the left.</source>
        <translation>記録を左へ移します。</translation>
    </message>
    <message>
        <source>Later ▸</source>
        <translation>後へ ▸</translation>
    </message>
    <message>
        <source>Moves the recording to the right.</source>
        <translation>記録を右へ移します。</translation>
    </message>
    <message>
        <source>Draws a recording in pale lines below the live traces, aligned to the start of the last motion.</source>
        <translation>記録を、ライブ波形の下に淡い線で描きます。最後の動作の始まりに合わせます。</translation>
    </message>
    <message>
        <source>Overlay a recording</source>
        <translation>記録の重ね表示</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePanel</name>
    <message>
        <source>Exports the visible samples or a picture.</source>
        <translation>表示中のサンプルまたは画像をエクスポートします。</translation>
    </message>
    <message>
        <source>Bits of the lane</source>
        <translation>ステータス欄のビット</translation>
    </message>
    <message>
        <source>%1 (simulator)</source>
        <translation>%1（シミュレーター）</translation>
    </message>
    <message>
        <source>Saves and restores arrangements of the scope by name.</source>
        <translation>スコープの配置を名前で保存および復元します。</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePlot</name>
    <message>
        <source>%1 · unknown</source>
        <translation>%1 · 不明</translation>
    </message>
    <message>
        <source>%1 · %2/s</source>
        <translation>%1 · %2/s</translation>
    </message>
    <message>
        <source>The band exceeds the strip: %1 to %2</source>
        <translation>帯が表示欄を超えています：%1～%2</translation>
    </message>
</context>
<context>
    <name>nmc::ScopePresets</name>
    <message>
        <source>Presets</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>&amp;Remove preset</source>
        <translation>プリセットを削除(&amp;R)</translation>
    </message>
    <message>
        <source>Remove preset</source>
        <translation>プリセットを削除</translation>
    </message>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>プリセットとして保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Keeps the present signals, strips, bits and time under a name.</source>
        <translation>現在の信号、表示欄、ビット、時間を名前を付けて保存します。</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>プリセットとして保存</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Replaces the preset of that name.</source>
        <translation>同じ名前のプリセットを置き換えます。</translation>
    </message>
    <message>
        <source>There are %1 presets, which is the most. Remove one first.</source>
        <translation>プリセットが上限の%1個あります。先に1つ削除してください。</translation>
    </message>
</context>
<context>
    <name>nmc::ScopeStrips</name>
    <message>
        <source>Plots; arrow keys move, plus and minus zoom</source>
        <translation>グラフ（矢印キーで移動、＋と－で拡大縮小）</translation>
    </message>
    <message>
        <source>Strip %1 of the scope</source>
        <translation>スコープの表示欄%1</translation>
    </message>
    <message>
        <source>Drag to resize the strips. Double-click to make them equal.</source>
        <translation>ドラッグして表示欄の大きさを変えます。ダブルクリックで均等になります。</translation>
    </message>
</context>
<context>
    <name>nmc::SequencesPage</name>
    <message>
        <source>Rename point</source>
        <translation>ポイント名の変更</translation>
    </message>
    <message>
        <source>Change row</source>
        <translation>行の変更</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>ポイント一覧</translation>
    </message>
    <message>
        <source>Name of the point to teach</source>
        <translation>教示するポイントの名前</translation>
    </message>
    <message>
        <source>Name of a point</source>
        <translation>ポイントの名前</translation>
    </message>
    <message>
        <source>Axes to teach</source>
        <translation>教示する軸</translation>
    </message>
    <message>
        <source>The selected axes become part of the point.</source>
        <translation>選択した軸がポイントに含まれます。</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>教示</translation>
    </message>
    <message>
        <source>Teach a point: store the positions of the selected axes</source>
        <translation>教示：選択した軸の位置をポイントに保存</translation>
    </message>
    <message>
        <source>Go to point</source>
        <translation>ポイントへ移動</translation>
    </message>
    <message>
        <source>Go to point: the selected one</source>
        <translation>ポイントへ移動：選択中のポイント</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>ポイントを削除</translation>
    </message>
    <message>
        <source>Remove point: the selected one</source>
        <translation>ポイントを削除：選択中のポイント</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>シーケンス一覧</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>シーケンス</translation>
    </message>
    <message>
        <source>Name of the sequence</source>
        <translation>シーケンスの名前</translation>
    </message>
    <message>
        <source>Type a new name for this sequence, then press Enter.</source>
        <translation>このシーケンスの新しい名前を入力し、Enterを押してください。</translation>
    </message>
    <message>
        <source>New sequence</source>
        <translation>新しいシーケンス</translation>
    </message>
    <message>
        <source>Remove sequence</source>
        <translation>シーケンスを削除</translation>
    </message>
    <message>
        <source>Remove sequence with its rows</source>
        <translation>シーケンスを削除：行も含む</translation>
    </message>
    <message>
        <source>Rows of the sequence</source>
        <translation>シーケンスの行</translation>
    </message>
    <message>
        <source>Double-click a cell or press F2 to edit it.</source>
        <translation>セルをダブルクリックするかF2を押すと編集できます。</translation>
    </message>
    <message>
        <source>Result of the dry run</source>
        <translation>模擬実行の結果</translation>
    </message>
    <message>
        <source>Rename sequence</source>
        <translation>シーケンス名の変更</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>行を追加</translation>
    </message>
    <message>
        <source>Add row after the selected one</source>
        <translation>行を追加：選択した行の後</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Duplicate the selected row</source>
        <translation>複製：選択した行</translation>
    </message>
    <message>
        <source>Duplicate row</source>
        <translation>行の複製</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>行を削除</translation>
    </message>
    <message>
        <source>Remove row: the selected one</source>
        <translation>行を削除：選択した行</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Up: move the selected row</source>
        <translation>上へ：選択した行を移動</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Down: move the selected row</source>
        <translation>下へ：選択した行を移動</translation>
    </message>
    <message>
        <source>Undo the last change to points and sequences</source>
        <translation>元に戻す：ポイントとシーケンスの最後の変更</translation>
    </message>
    <message>
        <source>Redo the last undone change to points and sequences</source>
        <translation>やり直し：元に戻したポイントとシーケンスの変更</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>模擬実行</translation>
    </message>
    <message>
        <source>Dry run: simulate the sequence; nothing moves</source>
        <translation>模擬実行：シーケンスをシミュレーション、何も動かさない</translation>
    </message>
    <message>
        <source>Dry run…</source>
        <translation>模擬実行…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運転</translation>
    </message>
    <message>
        <source>Run the sequence</source>
        <translation>運転：シーケンスを開始</translation>
    </message>
    <message>
        <source>Run from row</source>
        <translation>行から運転</translation>
    </message>
    <message>
        <source>Run from row: start at the selected row</source>
        <translation>行から運転：選択した行から開始</translation>
    </message>
    <message>
        <source>Pause the sequence after its row</source>
        <translation>一時停止：現在の行の後</translation>
    </message>
    <message>
        <source>Single step</source>
        <translation>シングルステップ</translation>
    </message>
    <message>
        <source>Single step: run one row of the sequence</source>
        <translation>シングルステップ：シーケンスを1行実行</translation>
    </message>
    <message>
        <source>Stop sequence</source>
        <translation>シーケンスを停止</translation>
    </message>
    <message>
        <source>Stop sequence and its motors</source>
        <translation>シーケンスを停止：そのモーターも停止</translation>
    </message>
    <message>
        <source>Teach point</source>
        <translation>ポイントの教示</translation>
    </message>
    <message>
        <source>Move row</source>
        <translation>行の移動</translation>
    </message>
    <message>
        <source>Enter a name for the point first.</source>
        <translation>先にポイントの名前を入力してください。</translation>
    </message>
    <message>
        <source>Select at least one axis.</source>
        <translation>軸を1つ以上選択してください。</translation>
    </message>
    <message>
        <source>Stores the present positions of the selected axes under this name, replacing any point of that name. Nothing moves.</source>
        <translation>選択した軸の現在位置を、この名前で保存します。同じ名前のポイントは置き換えられます。何も動きません。</translation>
    </message>
    <message>
        <source>Select a point in the table.</source>
        <translation>表でポイントを選択してください。</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; uses this point. Change that row first.</source>
        <translation>「%2」の%1行目がこのポイントを使用しています。先にその行を変更してください。</translation>
    </message>
    <message>
        <source>Moves all axes of this point there together, each at its own velocity.</source>
        <translation>このポイントの全軸を、それぞれの速度で同時にそこへ移動します。</translation>
    </message>
    <message>
        <source>Removes this point; nothing moves.</source>
        <translation>このポイントを削除します。何も動きません。</translation>
    </message>
    <message>
        <source>No sequence yet. Add one first.</source>
        <translation>シーケンスがありません。先に追加してください。</translation>
    </message>
    <message>
        <source>Select a row in the table.</source>
        <translation>表で行を選択してください。</translation>
    </message>
    <message>
        <source>Adds an empty sequence.</source>
        <translation>空のシーケンスを追加します。</translation>
    </message>
    <message>
        <source>Row %1 of &quot;%2&quot; calls this sequence. Change that row first.</source>
        <translation>「%2」の%1行目がこのシーケンスを呼び出しています。先にその行を変更してください。</translation>
    </message>
    <message>
        <source>Removes this sequence with its rows.</source>
        <translation>このシーケンスを行とともに削除します。</translation>
    </message>
    <message>
        <source>Adds a row after the selected one, or at the end.</source>
        <translation>選択した行の後、または末尾に行を追加します。</translation>
    </message>
    <message>
        <source>Adds a copy of the row after it.</source>
        <translation>この行のコピーを、その後に追加します。</translation>
    </message>
    <message>
        <source>Removes this row.</source>
        <translation>この行を削除します。</translation>
    </message>
    <message>
        <source>The row cannot move farther: a repeat must stay below the row it goes back to.</source>
        <translation>行をこれ以上移動できません。繰り返しは、戻り先の行より下になければなりません。</translation>
    </message>
    <message>
        <source>Moves this row up.</source>
        <translation>この行を上へ移動します。</translation>
    </message>
    <message>
        <source>Moves this row down.</source>
        <translation>この行を下へ移動します。</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>元に戻す：%1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>やり直し：%1</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from its first row.</source>
        <translation>「%1」を最初の行から運転します。</translation>
    </message>
    <message>
        <source>Runs &quot;%1&quot; from the selected row on. The axes must be where the rows above leave them.</source>
        <translation>「%1」を選択した行から運転します。各軸は、それより上の行を終えた位置になければなりません。</translation>
    </message>
    <message>
        <source>No sequence is running.</source>
        <translation>運転中のシーケンスはありません。</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>続行</translation>
    </message>
    <message>
        <source>Continues from where it paused.</source>
        <translation>一時停止したところから続けます。</translation>
    </message>
    <message>
        <source>Finishes the current row, then waits.</source>
        <translation>現在の行を終えてから待機します。</translation>
    </message>
    <message>
        <source>The sequence is running. Pause it first.</source>
        <translation>シーケンスは運転中です。先に一時停止してください。</translation>
    </message>
    <message>
        <source>Runs one row, then waits. Starts with the selected row.</source>
        <translation>1行を実行して待機します。選択した行から始まります。</translation>
    </message>
    <message>
        <source>Ends the sequence and stops its motors smoothly.</source>
        <translation>シーケンスを終了し、そのモーターを減速停止します。</translation>
    </message>
    <message>
        <source>End dry run</source>
        <translation>模擬実行を終了</translation>
    </message>
    <message>
        <source>Simulates the sequence: shows how long it takes, where each axis goes and what would be refused. Nothing moves.</source>
        <translation>シーケンスをシミュレーションします。所要時間、各軸の移動先、拒否される内容を表示します。何も動きません。</translation>
    </message>
</context>
<context>
    <name>nmc::ServoPanel</name>
    <message>
        <source>Servo module</source>
        <translation>サーボモジュール</translation>
    </message>
    <message>
        <source>Limits &amp;&amp; I/O</source>
        <translation>リミット &amp;&amp; I/O</translation>
    </message>
</context>
<context>
    <name>nmc::SignalsDialog</name>
    <message>
        <source>Signals of the scope</source>
        <translation>スコープの信号</translation>
    </message>
    <message>
        <source>Signals and their strips</source>
        <translation>信号と表示欄</translation>
    </message>
    <message>
        <source>Strip %1</source>
        <translation>表示欄%1</translation>
    </message>
    <message>
        <source>Select the strips of each signal. Empty strips are hidden.</source>
        <translation>各信号の表示欄を選択します。空の表示欄は表示されません。</translation>
    </message>
    <message>
        <source>The selected module</source>
        <translation>選択したモジュール</translation>
    </message>
    <message>
        <source>&amp;Usual signals</source>
        <translation>標準の信号(&amp;U)</translation>
    </message>
    <message>
        <source>Usual signals</source>
        <translation>標準の信号</translation>
    </message>
    <message>
        <source>%1: %2 in strip %3</source>
        <translation>%1：%2を表示欄%3に</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>フィルター</translation>
    </message>
    <message>
        <source>Filter by module or signal</source>
        <translation>フィルター：モジュールまたは信号</translation>
    </message>
    <message>
        <source>Position and command position, with the error and the motor current below.</source>
        <translation>位置と指令位置、その下に偏差とモーター電流。</translation>
    </message>
    <message>
        <source>&amp;Custom traces…</source>
        <translation>カスタム波形(&amp;C)…</translation>
    </message>
    <message>
        <source>Custom traces</source>
        <translation>カスタム波形</translation>
    </message>
    <message>
        <source>Traces of your own, from one or two signals.</source>
        <translation>1つまたは2つの信号から作る波形です。</translation>
    </message>
</context>
<context>
    <name>nmc::SimulatorBench</name>
    <message>
        <source>Simulated module</source>
        <translation>シミュレーションモジュール</translation>
    </message>
    <message>
        <source>Follows the module list, and includes modules that the panel did not find.</source>
        <translation>モジュール一覧に従います。パネルが検出しなかったモジュールも含みます。</translation>
    </message>
</context>
<context>
    <name>nmc::SpectrumDialog</name>
    <message>
        <source>Peak</source>
        <translation>ピーク</translation>
    </message>
    <message>
        <source>Spectrum between the cursors</source>
        <translation>カーソル間のスペクトル</translation>
    </message>
    <message>
        <source>&amp;Signal</source>
        <translation>信号(&amp;S)</translation>
    </message>
    <message>
        <source>Peak: %1 Hz, amplitude %2 %3</source>
        <translation>ピーク：%1 Hz、振幅%2 %3</translation>
    </message>
    <message>
        <source>No oscillation stands out from the noise.</source>
        <translation>ノイズから際立つ振動はありません。</translation>
    </message>
    <message>
        <source>From %1 Hz, two periods between the cursors, to %2 Hz, nearly half the rate of the samples.</source>
        <translation>%1 Hz（カーソル間に2周期）から%2 Hz（サンプルレートのほぼ半分）まで。</translation>
    </message>
    <message>
        <source>There is a long gap between the cursors. Move both to the same side of it.</source>
        <translation>カーソル間にデータの長い欠落があります。両方のカーソルを欠落の同じ側に移動してください。</translation>
    </message>
</context>
<context>
    <name>nmc::SpectrumPlot</name>
    <message>
        <source>Spectrum</source>
        <translation>スペクトル</translation>
    </message>
    <message>
        <source>The sines in the signal, by frequency in Hz. The circle marks the highest that stands out from the noise. Double-click to show everything. Scroll to zoom the frequency, or the amplitudes with Ctrl; drag to pan; drag with Shift to select frequencies.</source>
        <translation>信号に含まれる正弦波を周波数（Hz）ごとに表示します。丸印はノイズから際立つ最も高いものです。ダブルクリックで全体を表示します。スクロールで周波数を、Ctrlを押しながらで振幅を拡大縮小し、ドラッグで表示を移動し、Shiftを押しながらドラッグして周波数を選択します。</translation>
    </message>
</context>
<context>
    <name>nmc::SquarePlot</name>
    <message>
        <source>Square wave, one period</source>
        <translation>矩形波、1周期</translation>
    </message>
    <message>
        <source>median, %1</source>
        <translation>中央値、%1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>No edge recorded yet. A square wave overlays many steps while you change gains.</source>
        <translation>エッジはまだ記録されていません。矩形波では、ゲインを変えながら多数のステップを重ねて表示します。</translation>
    </message>
    <message>
        <source>All edges with the present gains, overlaid: the line is their median, the shaded band holds 80 % of the samples. Pale: the previous gains. Double-click to show everything. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time.</source>
        <translation>現在のゲインでの全エッジを重ねたものです。線は中央値、網掛けの帯はサンプルの80%の範囲です。淡色：以前のゲイン。ダブルクリックで全体を表示します。スクロールで時間を、Ctrlを押しながらで位置を拡大縮小し、ドラッグで表示を移動し、Shiftを押しながらドラッグして時間を選択します。</translation>
    </message>
</context>
<context>
    <name>nmc::SquareWavePage</name>
    <message>
        <source>Start test</source>
        <translation>テスト開始</translation>
    </message>
    <message>
        <source>The motor jumps back and forth around its position. Make sure that everything it drives can move freely.</source>
        <translation>モーターが現在位置を中心に前後に急に動きます。駆動されるものがすべて自由に動けることを確認してください。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>The distance</source>
        <translation>距離の値</translation>
    </message>
    <message>
        <source>From side to side: half to either side of the present position.</source>
        <translation>端から端までの距離です。現在位置から両側に半分ずつです。</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>The period</source>
        <translation>周期の値</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>周期数</translation>
    </message>
    <message>
        <source>Periods to run</source>
        <translation>実行する周期数</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>許容変位</translation>
    </message>
    <message>
        <source>How far the motor may move past either side. Beyond that, the test stops and the motor holds.</source>
        <translation>両端からさらに動いてよい距離です。これを超えるとテストを停止し、モーターを保持します。</translation>
    </message>
    <message>
        <source>Results of the edges</source>
        <translation>エッジの結果</translation>
    </message>
    <message>
        <source>Keep as a run</source>
        <translation>測定として保存</translation>
    </message>
    <message>
        <source>Keep as a run: the median edge</source>
        <translation>測定として保存：エッジの中央値</translation>
    </message>
    <message>
        <source>Settling %1</source>
        <translation>整定 %1</translation>
    </message>
    <message>
        <source>No edge recorded yet.</source>
        <translation>エッジはまだ記録されていません。</translation>
    </message>
    <message>
        <source>Adds the median of the rising edges to the list of step responses.</source>
        <translation>立ち上がりエッジの中央値を、ステップ応答の一覧に追加します。</translation>
    </message>
    <message>
        <source>Edges with these gains: %1</source>
        <translation>このゲインでのエッジ：%1</translation>
    </message>
</context>
<context>
    <name>nmc::StagedForm</name>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>編集を破棄</translation>
    </message>
    <message>
        <source>✓ sent</source>
        <translation>✓ 送信済み</translation>
    </message>
    <message>
        <source>● not sent</source>
        <translation>● 未送信</translation>
    </message>
    <message>
        <source>Undoes the last edit in these fields. Sends nothing.</source>
        <translation>これらの欄の最後の編集を元に戻します。何も送信しません。</translation>
    </message>
    <message>
        <source>Redoes the edit that was undone. Sends nothing.</source>
        <translation>元に戻した編集をやり直します。何も送信しません。</translation>
    </message>
    <message>
        <source>No changes to apply.</source>
        <translation>適用する変更がありません。</translation>
    </message>
</context>
<context>
    <name>nmc::StartPage</name>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Start the simulator</source>
        <translation>シミュレーターを開始</translation>
    </message>
    <message>
        <source>Needs no hardware. Three simulated modules to try everything on; no real motor moves.</source>
        <translation>ハードウェアは不要です。3台のシミュレーションモジュールですべてを試せます。実際のモーターは動きません。</translation>
    </message>
    <message>
        <source>Connects to the built-in simulator.</source>
        <translation>内蔵シミュレーターに接続します。</translation>
    </message>
    <message>
        <source>Choose a serial port…</source>
        <translation>シリアルポートを選択…</translation>
    </message>
    <message>
        <source>No serial port found. Plug in the modules&apos; adapter; it then appears here.</source>
        <translation>シリアルポートが見つかりません。モジュールのアダプターを差し込むと、ここに表示されます。</translation>
    </message>
    <message>
        <source>%1 Bd.</source>
        <translation>%1 Bd。</translation>
    </message>
    <message>
        <source>%1, %2 Bd.</source>
        <translation>%1、%2 Bd。</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>%1に接続</translation>
    </message>
    <message>
        <source>The modules must be powered and their cable plugged in.</source>
        <translation>モジュールの電源を入れ、ケーブルを接続しておいてください。</translation>
    </message>
    <message>
        <source>Other ports are in the list above.</source>
        <translation>ほかのポートは上の一覧にあります。</translation>
    </message>
</context>
<context>
    <name>nmc::StatusLane</name>
    <message>
        <source>Status bits over time</source>
        <translation>ステータスビットの推移</translation>
    </message>
</context>
<context>
    <name>nmc::StepperIoBox</name>
    <message>
        <source>Set all outputs</source>
        <translation>全出力を設定</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>入出力</translation>
    </message>
    <message>
        <source>OUT%1</source>
        <translation>OUT%1</translation>
    </message>
    <message>
        <source>Name of output %1</source>
        <translation>出力%1の名前</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>Name of input %1</source>
        <translation>入力%1の名前</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>無視</translation>
    </message>
    <message>
        <source>keeps the motor from moving</source>
        <translation>モーターを動かさない</translation>
    </message>
    <message>
        <source>blocks forward</source>
        <translation>正方向を禁止</translation>
    </message>
    <message>
        <source>blocks reverse</source>
        <translation>逆方向を禁止</translation>
    </message>
    <message>
        <source>● %1, not sent</source>
        <translation>● %1、未送信</translation>
    </message>
    <message>
        <source>Selects the level. Choose Set all outputs to send all five.</source>
        <translation>レベルを選択します。「全出力を設定」で5つすべてを送信します。</translation>
    </message>
    <message>
        <source>Select a level for all five outputs first.</source>
        <translation>先に5つの出力すべてのレベルを選択してください。</translation>
    </message>
    <message>
        <source>Sends all five outputs as selected above.</source>
        <translation>上で選択したとおりに、5つの出力すべてを送信します。</translation>
    </message>
    <message>
        <source>Outputs unknown: they cannot be read back. Select all five levels, then set them.</source>
        <translation>出力は不明です。読み出せません。5つすべてのレベルを選択してから、設定してください。</translation>
    </message>
</context>
<context>
    <name>nmc::StepperMotionBox</name>
    <message>
        <source>b&amp;y this distance</source>
        <translation>この距離だけ(&amp;Y)</translation>
    </message>
    <message>
        <source>By this distance from the present position</source>
        <translation>この距離だけ：現在位置から</translation>
    </message>
    <message>
        <source>The speed</source>
        <translation>速度の値</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>位置(&amp;P)</translation>
    </message>
    <message>
        <source>Trave&amp;l speed</source>
        <translation>移動速度(&amp;L)</translation>
    </message>
    <message>
        <source>Load o&amp;nly</source>
        <translation>ロードのみ(&amp;N)</translation>
    </message>
    <message>
        <source>Load only, start later</source>
        <translation>ロードのみ：後で開始</translation>
    </message>
    <message>
        <source>Start loaded</source>
        <translation>ロード済みを開始</translation>
    </message>
    <message>
        <source>Start loaded motion</source>
        <translation>ロード済みを開始：動作</translation>
    </message>
    <message>
        <source>How fast the motor turns: %1 to %2 in this speed mode. The chip uses the nearest speed available.</source>
        <translation>モーターの回る速さです：この速度モードでは%1～%2。チップは使用できる最も近い速度を使います。</translation>
    </message>
    <message>
        <source>At constant speed, without a ramp.</source>
        <translation>一定速度、加減速なしです。</translation>
    </message>
    <message>
        <source>Takes %1 s from standstill.</source>
        <translation>停止状態から%1秒かかります。</translation>
    </message>
    <message>
        <source>Stop, wait: %1</source>
        <translation>停止、待機：%1</translation>
    </message>
    <message>
        <source>Loads the motion without starting it.</source>
        <translation>動作を開始せずにロードします。</translation>
    </message>
    <message>
        <source>Load &amp;reverse</source>
        <translation>逆方向にロード(&amp;R)</translation>
    </message>
    <message>
        <source>Load forward</source>
        <translation>正方向にロード</translation>
    </message>
    <message>
        <source>Starts the loaded motion.</source>
        <translation>ロード済みの動作を開始します。</translation>
    </message>
    <message>
        <source>A run has no goal.</source>
        <translation>運転には目標位置がありません。</translation>
    </message>
    <message>
        <source>The goal of the move. Press Enter to start.</source>
        <translation>移動の目標位置です。Enterで開始します。</translation>
    </message>
    <message>
        <source>The distance counts from where the motor is at the start.</source>
        <translation>開始時のモーターの位置からの距離です。</translation>
    </message>
    <message>
        <source>The buttons only load the motion. Choose Start loaded, or start the module&apos;s group.</source>
        <translation>ボタンでは動作をロードするだけです。「ロード済みを開始」を選択するか、モジュールのグループを開始してください。</translation>
    </message>
    <message>
        <source>No ramp.</source>
        <translation>加減速なし。</translation>
    </message>
    <message>
        <source>Stops smoothly, waits until the motor is at rest, then: %1</source>
        <translation>減速停止し、モーターの停止を待ってから：%1</translation>
    </message>
    <message>
        <source>Moves to home with a ramp, at the travel speed.</source>
        <translation>加減速しながら、「移動速度」で原点へ移動します。</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Moves to a position with ramps (trapezoidal profile mode).</source>
        <translation>加減速のある位置への移動です（台形プロファイルモード）。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運転</translation>
    </message>
    <message>
        <source>Ramps to a speed and keeps it until stopped (velocity profile mode).</source>
        <translation>指定速度まで加減速し、停止操作をするまでその速度を保ちます（速度プロファイルモード）。</translation>
    </message>
    <message>
        <source>Move without ramp</source>
        <translation>加減速なし移動</translation>
    </message>
    <message>
        <source>Moves to a position at constant speed, without ramps. At too high a speed the motor loses steps (unprofiled, with stop).</source>
        <translation>加減速なしの一定速度で位置へ移動します。速度が高すぎると、モーターが脱調します（プロファイルなし、停止あり）。</translation>
    </message>
    <message>
        <source>Run without ramp</source>
        <translation>加減速なし運転</translation>
    </message>
    <message>
        <source>Runs at constant speed, without a ramp, until stopped. At too high a speed the motor loses steps (unprofiled, without stop).</source>
        <translation>停止操作をするまで、加減速なしの一定速度で運転します。速度が高すぎると、モーターが脱調します（プロファイルなし、停止なし）。</translation>
    </message>
    <message>
        <source>Kind of motion</source>
        <translation>動作の種類</translation>
    </message>
</context>
<context>
    <name>nmc::StepperPanel</name>
    <message>
        <source>Stepper module</source>
        <translation>ステッピングモーターモジュール</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>I/O</translation>
    </message>
</context>
<context>
    <name>nmc::StepperParametersBox</name>
    <message>
        <source>ignored: no motor stop</source>
        <translation>無視：何も停止しません</translation>
    </message>
    <message>
        <source>motor switches off, too</source>
        <translation>モーターもオフになります</translation>
    </message>
    <message>
        <source>&amp;Apply parameters</source>
        <translation>パラメーターを適用(&amp;A)</translation>
    </message>
    <message>
        <source>Revert the parameters to those last sent</source>
        <translation>編集を破棄：最後に送信したパラメーターに戻す</translation>
    </message>
    <message>
        <source>Apply parameters: all</source>
        <translation>パラメーターを適用：すべて</translation>
    </message>
    <message>
        <source>Fills in low speeds and currents to start with. Sends nothing.</source>
        <translation>手始めとして低い速度と小さい電流を入力します。何も送信しません。</translation>
    </message>
    <message>
        <source>Choose a speed mode.</source>
        <translation>速度モードを選択してください。</translation>
    </message>
    <message>
        <source>Parameters cannot be read back from the module. The motor moves only after you apply them.</source>
        <translation>パラメーターはモジュールから読み出せません。適用するまでモーターは動きません。</translation>
    </message>
    <message>
        <source>If checked, the E-stop input does not stop the motor.</source>
        <translation>チェックすると、E-stop入力でモーターが停止しません。</translation>
    </message>
    <message>
        <source>If checked, the limit switches do not stop the motor.</source>
        <translation>チェックすると、リミットスイッチでモーターが停止しません。</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The amplifier is on: currents and limits take effect immediately.</source>
        <translation>すべてのパラメーターを一度に送信します。アンプがオンのため、電流と制限は直ちに有効になります。</translation>
    </message>
    <message>
        <source>Sends all parameters at once. The motor does not move.</source>
        <translation>すべてのパラメーターを一度に送信します。モーターは動きません。</translation>
    </message>
    <message>
        <source>Restores the parameters last sent. Sends nothing.</source>
        <translation>最後に送信したパラメーターに戻します。何も送信しません。</translation>
    </message>
    <message>
        <source>Clears the fields: no parameters have been sent yet. Sends nothing.</source>
        <translation>欄を空にします。パラメーターはまだ送信していません。何も送信しません。</translation>
    </message>
    <message>
        <source>Undo the last edit of a parameter</source>
        <translation>元に戻す：パラメーターの最後の編集</translation>
    </message>
    <message>
        <source>Redo the edit of a parameter</source>
        <translation>やり直し：パラメーターの編集</translation>
    </message>
    <message>
        <source>Speed mode</source>
        <translation>速度モード</translation>
    </message>
    <message>
        <source>Minimum profile speed</source>
        <translation>最小プロファイル速度</translation>
    </message>
    <message>
        <source>Run current</source>
        <translation>運転電流</translation>
    </message>
    <message>
        <source>Hold current</source>
        <translation>保持電流</translation>
    </message>
    <message>
        <source>Thermal limit</source>
        <translation>温度制限</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>リミットスイッチ</translation>
    </message>
    <message>
        <source>On limit or E-stop</source>
        <translation>リミットまたはE-stop時</translation>
    </message>
    <message>
        <source>The clock of the step timer. A faster clock reaches higher speeds in coarser steps: use the slowest one that is fast enough. Changing it changes the meaning of every speed and ramp.</source>
        <translation>ステップタイマーのクロックです。速いクロックほど高い速度に届きますが、速度の刻みが粗くなります。足りる範囲で最も遅いものを使ってください。変更すると、すべての速度と加減速の意味が変わります。</translation>
    </message>
    <message>
        <source>The speed at which ramps start and end. The motor must be able to start and stop at this speed without losing steps. Runs and moves with a ramp are never slower.</source>
        <translation>加減速の開始と終了の速度です。モーターがこの速度で脱調せずに起動、停止できる必要があります。加減速のある運転と移動は、これより遅くなりません。</translation>
    </message>
    <message>
        <source>Motor current while moving; 255 is the driver&apos;s full current. 0: no current, and the motor does not follow. Do not exceed the ratings of motor and driver.</source>
        <translation>モーターが動いている間の電流です。255がドライバーの最大電流です。0：電流なし、モーターは追従しません。モーターとドライバーの定格を超えないでください。</translation>
    </message>
    <message>
        <source>Motor current at rest, from about 0.25 s after a motion. Usually lower than the run current, to keep the motor cool. 0: no current, and no holding torque.</source>
        <translation>停止中のモーター電流です。動作終了の約0.25秒後から適用されます。モーターの発熱を抑えるため、通常は運転電流より小さくします。0：電流なし、モーターは何も保持しません。</translation>
    </message>
    <message>
        <source>The module switches the motor off when the A/D value falls below this limit: the voltage of a thermistor bridge falls as the motor warms up. 0: off. To find the right limit, watch the A/D value of a warm motor.</source>
        <translation>A/D値がこの値を下回ると、モジュールがモーターをオフにします。モーターが温まるとサーミスターブリッジの電圧が下がります。0：オフ。適切な値を決めるには、温まったモーターのA/D値を見てください。</translation>
    </message>
    <message>
        <source>Normally the chip stops the motor at limit switch 1 going forward and at limit switch 2 in reverse. When ignored, the switches do not stop the motor, and it can run into the end of its travel.</source>
        <translation>通常、チップは正方向ではリミットスイッチ1、逆方向ではリミットスイッチ2で停止します。無視すると、スイッチでは何も停止せず、モーターがストローク端に突き当たることがあります。</translation>
    </message>
    <message>
        <source>Normally the chip stops the motor when its E-stop input goes high. When ignored, the input does not stop the motor.</source>
        <translation>通常、チップはE-stop入力がHighになるとモーターを停止します。無視すると、この入力では何も停止しません。</translation>
    </message>
    <message>
        <source>A limit switch or the E-stop input also switches the motor off: it is free to turn, and a load may fall.</source>
        <translation>リミットスイッチまたはE-stop入力で、モーターもオフになります。モーターは自由に回る状態になり、負荷が落下することがあります。</translation>
    </message>
    <message>
        <source>A/D now %1</source>
        <translation>A/D現在値 %1</translation>
    </message>
    <message>
        <source>off; %1</source>
        <translation>オフ、%1</translation>
    </message>
    <message>
        <source>no current</source>
        <translation>電流なし</translation>
    </message>
    <message>
        <source>%1 % of full</source>
        <translation>最大の%1%</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>速度%1</translation>
    </message>
    <message>
        <source>The acceleration time</source>
        <translation>加速時間の値</translation>
    </message>
    <message>
        <source>How long a ramp stays at each speed, in units of 0.25 ms; smaller is steeper. Sent with the next motion that has a ramp, and used by smooth stops after it.</source>
        <translation>加減速が各速度に留まる時間（0.25 ms単位）です。小さいほど急になります。次の加減速のある動作とともに送信され、その後の減速停止にも使用されます。</translation>
    </message>
    <message>
        <source>Jog is never faster than this. Set a speed that you can react to.</source>
        <translation>ジョグはこの速度を超えません。とっさに対応できる速度を設定してください。</translation>
    </message>
    <message>
        <source>With every motion</source>
        <translation>各動作とともに送信</translation>
    </message>
    <message>
        <source>× 0.25 ms</source>
        <translation>× 0.25 ms</translation>
    </message>
</context>
<context>
    <name>nmc::StopButton</name>
    <message>
        <source>STOP ALL  Esc</source>
        <translation>全停止  Esc</translation>
    </message>
    <message>
        <source>STOP ALL  Esc: stop all motors</source>
        <translation>全停止  Esc：すべてのモーターを停止</translation>
    </message>
    <message>
        <source>Stops every motor. Unavailable: no port is open.</source>
        <translation>すべてのモーターを停止します。使用不可：ポートが開いていません。</translation>
    </message>
    <message>
        <source>Stops every motor on this line at once; Esc does the same from anywhere. It %1.
It works only while the link works: fit a hardware stop as well.</source>
        <translation>この回線のすべてのモーターを直ちに停止します。どこからでもEscで同じ操作ができます（%1）。
通信できる間だけ有効です。ハードウェア停止装置も設置してください。</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
</context>
<context>
    <name>nmc::StretchDialog</name>
    <message>
        <source>These samples are no longer kept individually. Move the cursors to newer ones.</source>
        <translation>これらのサンプルは個別には保存されていません。カーソルを新しいサンプルに移動してください。</translation>
    </message>
    <message>
        <source>%1 samples are between the cursors, and %2 are the most. Move the cursors closer together.</source>
        <translation>カーソル間に%1個のサンプルがあり、上限は%2個です。カーソルを近づけてください。</translation>
    </message>
    <message>
        <source>Too few samples are between the cursors. Move them farther apart.</source>
        <translation>カーソル間のサンプルが少なすぎます。カーソルの間隔を広げてください。</translation>
    </message>
</context>
<context>
    <name>nmc::TestForm</name>
    <message>
        <source>End test</source>
        <translation>テストを終了</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>テストの進行状況</translation>
    </message>
    <message>
        <source>The test is already running.</source>
        <translation>テストはすでに実行中です。</translation>
    </message>
    <message>
        <source>The test is not running.</source>
        <translation>テストは実行していません。</translation>
    </message>
</context>
<context>
    <name>nmc::TracesDialog</name>
    <message>
        <source>Custom traces</source>
        <translation>カスタム波形</translation>
    </message>
    <message>
        <source>Each trace is the sum of one or two signals, each times a factor. Values are taken in the units in which the signals are shown; a negative factor subtracts.</source>
        <translation>各波形は、1つまたは2つの信号にそれぞれ係数を掛けた和です。値には表示中の単位を使います。負の係数は引き算になります。</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>係数</translation>
    </message>
    <message>
        <source>Second signal</source>
        <translation>2つ目の信号</translation>
    </message>
    <message>
        <source>Low-pass, Hz</source>
        <translation>ローパス、Hz</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>適用(&amp;A)</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>一斉出力</translation>
    </message>
    <message>
        <source>%1, trace %2</source>
        <translation>%1、波形 %2</translation>
    </message>
    <message>
        <source>The name in the legend. Without one, there is no such trace.</source>
        <translation>凡例の名前です。名前がなければ波形はありません。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Selected module</source>
        <translation>選択したモジュール</translation>
    </message>
    <message>
        <source>Smooths the trace: what is faster than this frequency is attenuated, and the trace lags behind. Empty: no filter.</source>
        <translation>波形を滑らかにします。この周波数より速い成分は減衰し、波形は遅れます。空欄：フィルターなし。</translation>
    </message>
    <message>
        <source>Shown beside the name.</source>
        <translation>名前の横に表示されます。</translation>
    </message>
    <message>
        <source>Factor of: %1</source>
        <translation>係数：%1</translation>
    </message>
    <message>
        <source>The signal is multiplied by it.</source>
        <translation>信号に掛けられます。</translation>
    </message>
    <message>
        <source>A factor must not be 0.</source>
        <translation>係数は0にできません。</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
</context>
<context>
    <name>nmc::TravelBox</name>
    <message>
        <source>State of the travel limits</source>
        <translation>移動範囲の状態</translation>
    </message>
    <message>
        <source>Counted from home. No motion passes it while home is known. Empty: no limit.</source>
        <translation>原点からの値です。原点が分かっている間は、どの動作もこれを超えません。空欄：制限なし。</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>ここ</translation>
    </message>
    <message>
        <source>Here: make the present position the lowest</source>
        <translation>ここ：現在位置を最小位置に</translation>
    </message>
    <message>
        <source>Here: make the present position the highest</source>
        <translation>ここ：現在位置を最大位置に</translation>
    </message>
    <message>
        <source>Limits moves, runs, steps, jog and homing. Empty: the module&apos;s maximum.</source>
        <translation>移動、運転、ステップ、ジョグ、原点復帰を制限します。空欄：モジュールの最高速度。</translation>
    </message>
    <message>
        <source>Slightly more than the play between motor and load. A move from the other side overshoots its goal by this distance and comes back. Empty: none.</source>
        <translation>モーターと負荷の間の遊びよりわずかに大きい値です。反対側からの移動では、目標位置をこの距離だけ行き過ぎてから戻ります。空欄：なし。</translation>
    </message>
    <message>
        <source>Approach direction of every goal</source>
        <translation>目標位置への接近方向</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>下から</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>Go, Go home, steps, points and sequences approach their goals from this side. Loaded moves and paths go straight to theirs.</source>
        <translation>「移動」、「原点へ移動」、ステップ、ポイント、シーケンスは、目標位置にこの側から接近します。ロード済みの移動とパスは直接向かいます。</translation>
    </message>
    <message>
        <source>Confirm position…</source>
        <translation>位置を確認…</translation>
    </message>
    <message>
        <source>Confirm position as correct</source>
        <translation>位置を確認：正しい</translation>
    </message>
    <message>
        <source>Position in doubt</source>
        <translation>位置に疑いあり</translation>
    </message>
    <message>
        <source>Position in doubt: it may be wrong</source>
        <translation>位置に疑いあり：間違っている可能性</translation>
    </message>
    <message>
        <source>Confirm the position</source>
        <translation>位置の確認</translation>
    </message>
    <message>
        <source>Position &amp;is right</source>
        <translation>位置は正しい(&amp;I)</translation>
    </message>
    <message>
        <source>The lowest position must be below the highest. The old value is kept.</source>
        <translation>最小位置は最大位置より小さくなければなりません。元の値のままです。</translation>
    </message>
    <message>
        <source>Sets the lowest position to the present position.</source>
        <translation>現在位置を最小位置に設定します。</translation>
    </message>
    <message>
        <source>Sets the highest position to the present position.</source>
        <translation>現在位置を最大位置に設定します。</translation>
    </message>
    <message>
        <source>Confirms that the position is right: home is at position 0. Asks first.</source>
        <translation>位置が正しいことを確認します。位置0が原点です。実行前に確認します。</translation>
    </message>
    <message>
        <source>Marks home as unknown. The travel limits are not in force until home is known again.</source>
        <translation>原点を不明にします。原点が再び分かるまで、移動範囲の制限は無効です。</translation>
    </message>
    <message>
        <source>With this backlash, no move can end at home: it would reverse beyond the limit. Move the limit away from home, or change the backlash or its direction.</source>
        <translation>このバックラッシでは、原点で終わる移動ができません。リミットの外側で折り返すことになるためです。リミットを原点から離すか、バックラッシまたはその方向を変更してください。</translation>
    </message>
    <message>
        <source>Arrival tolerance</source>
        <translation>到着許容差</translation>
    </message>
    <message>
        <source>Sequences, and programs that wait, go on when the motor has stayed this close to its goal for the time beside it. Empty: when it stands still.</source>
        <translation>シーケンスと待機中のプログラムは、モーターが隣の時間だけ目標からこの範囲内にとどまると次に進みます。空欄：停止したとき。</translation>
    </message>
    <message>
        <source>Time within the arrival tolerance</source>
        <translation>到着許容差内の時間</translation>
    </message>
    <message>
        <source>How long the motor must stay within the tolerance.</source>
        <translation>モーターが許容差内にとどまらなければならない時間です。</translation>
    </message>
    <message>
        <source>Arrival within</source>
        <translation>到着の範囲</translation>
    </message>
    <message>
        <source>for</source>
        <translation>継続</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerBar</name>
    <message>
        <source>Trigger on</source>
        <translation>トリガー対象</translation>
    </message>
    <message>
        <source>The signal or status bit to wait for.</source>
        <translation>待機の対象となる信号またはステータスビットです。</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>The event to wait for.</source>
        <translation>待機の対象となる事象です。</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>The level for the event.</source>
        <translation>事象のレベルです。</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Single: holds the first picture. Normal: shows picture after picture.</source>
        <translation>シングル：最初の画面を保持します。ノーマル：画面を次々に表示します。</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>トリガー前</translation>
    </message>
    <message>
        <source>Share of the picture before the trigger, in percent.</source>
        <translation>トリガー前が画面に占める割合（パーセント）です。</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>待機開始</translation>
    </message>
    <message>
        <source>State of the trigger</source>
        <translation>トリガーの状態</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>シングル</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>ノーマル</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>rises to</source>
        <translation>上昇して到達</translation>
    </message>
    <message>
        <source>falls to</source>
        <translation>下降して到達</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>超えている</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>下回っている</translation>
    </message>
    <message>
        <source>becomes 1</source>
        <translation>1になる</translation>
    </message>
    <message>
        <source>becomes 0</source>
        <translation>0になる</translation>
    </message>
    <message>
        <source>is 1</source>
        <translation>1である</translation>
    </message>
    <message>
        <source>is 0</source>
        <translation>0である</translation>
    </message>
    <message>
        <source>No module connected.</source>
        <translation>接続中のモジュールがありません。</translation>
    </message>
    <message>
        <source>Choose a mode first.</source>
        <translation>先にモードを選択してください。</translation>
    </message>
    <message>
        <source>Waits for the next trigger.</source>
        <translation>次のトリガーを待ちます。</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerControl</name>
    <message>
        <source>waiting</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>triggered %1, more samples to come</source>
        <translation>トリガー済み %1、残りのサンプルを取得中</translation>
    </message>
    <message>
        <source>triggered %1</source>
        <translation>トリガー済み %1</translation>
    </message>
</context>
<context>
    <name>nmc::TriggerRecords</name>
    <message>
        <source>Save each picture…</source>
        <translation>各画面を保存…</translation>
    </message>
    <message>
        <source>Save each picture</source>
        <translation>各画面を保存</translation>
    </message>
    <message>
        <source>Saves the samples of each picture to a folder that you choose.</source>
        <translation>各画面のサンプルを、選択したフォルダーに保存します。</translation>
    </message>
    <message>
        <source>Keep the last</source>
        <translation>保持する数</translation>
    </message>
    <message>
        <source>How many files are kept. Then the oldest is replaced.</source>
        <translation>保持するファイルの数です。それを超えると最も古いものが置き換えられます。</translation>
    </message>
    <message>
        <source>Saved pictures</source>
        <translation>保存した画面</translation>
    </message>
    <message>
        <source>Save each picture to a folder</source>
        <translation>各画面をフォルダーに保存</translation>
    </message>
    <message>
        <source>%1 taken for %2</source>
        <translation>%2用に%1個を取り込みました</translation>
    </message>
</context>
<context>
    <name>nmc::TuningFiles</name>
    <message>
        <source>PIC-SERVO, version %1, address %2</source>
        <translation>PIC-SERVO、バージョン%1、アドレス%2</translation>
    </message>
    <message>
        <source>%1, %2 Bd</source>
        <translation>%1、%2 Bd</translation>
    </message>
    <message>
        <source>Save the tuning report</source>
        <translation>調整レポートの保存</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
</context>
<context>
    <name>nmc::UnitDialog</name>
    <message>
        <source>Calculate the unit</source>
        <translation>単位の計算</translation>
    </message>
    <message>
        <source>Type of axis</source>
        <translation>軸の種類</translation>
    </message>
    <message>
        <source>rotary, in turns</source>
        <translation>回転軸（回転数）</translation>
    </message>
    <message>
        <source>rotary, in degrees</source>
        <translation>回転軸（度）</translation>
    </message>
    <message>
        <source>linear, in millimetres</source>
        <translation>直動軸（ミリメートル）</translation>
    </message>
    <message>
        <source>The unit to display for this axis.</source>
        <translation>この軸に表示する単位です。</translation>
    </message>
    <message>
        <source>The axis</source>
        <translation>軸の選択</translation>
    </message>
    <message>
        <source>Full steps per motor turn</source>
        <translation>モーター1回転のフルステップ数</translation>
    </message>
    <message>
        <source>200 for a motor with 1.8 degrees per step.</source>
        <translation>1ステップ1.8度のモーターでは200です。</translation>
    </message>
    <message>
        <source>Microsteps per full step</source>
        <translation>1フルステップのマイクロステップ数</translation>
    </message>
    <message>
        <source>As set on the driver; 1 for full steps, 2 for half steps.</source>
        <translation>ドライバーの設定値です。フルステップは1、ハーフステップは2です。</translation>
    </message>
    <message>
        <source>Encoder lines per turn</source>
        <translation>エンコーダー1回転のライン数</translation>
    </message>
    <message>
        <source>As on its label: lines, CPR or PPR. The chip counts four per line.</source>
        <translation>ラベルの表示値です：ライン数、CPR、またはPPR。チップは1ラインを4カウントと数えます。</translation>
    </message>
    <message>
        <source>Gear: motor turns</source>
        <translation>ギア：モーター側の回転数</translation>
    </message>
    <message>
        <source>For a 50 : 1 gear, enter 50; without a gear, 1.</source>
        <translation>50 : 1のギアでは50を、ギアがなければ1を入力します。</translation>
    </message>
    <message>
        <source>Gear: output turns</source>
        <translation>ギア：出力側の回転数</translation>
    </message>
    <message>
        <source>For a 50 : 1 gear, enter 1.</source>
        <translation>50 : 1のギアでは1を入力します。</translation>
    </message>
    <message>
        <source>Travel per output turn (mm)</source>
        <translation>出力1回転の移動量 (mm)</translation>
    </message>
    <message>
        <source>Lead screw: pitch times starts. Belt: pulley teeth times belt pitch. Rack: pinion teeth times rack pitch.</source>
        <translation>送りねじ：ピッチ × 条数。ベルト：プーリー歯数 × ベルトピッチ。ラック：ピニオン歯数 × ラックピッチ。</translation>
    </message>
    <message>
        <source>Calculated unit</source>
        <translation>計算した単位</translation>
    </message>
    <message>
        <source>Use this unit</source>
        <translation>この単位を使用</translation>
    </message>
    <message>
        <source>Enter a number above 0 in each field.</source>
        <translation>各欄に0より大きい数値を入力してください。</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>カウント</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>1 %1 is %2 %3. The smallest step is %4 %5.</source>
        <translation>1 %1は%2 %3です。最小ステップは%4 %5です。</translation>
    </message>
    <message>
        <source>Sets this unit for the axis. Keeps every physical value and sends nothing.</source>
        <translation>この単位を軸に設定します。物理量は変わらず、何も送信しません。</translation>
    </message>
</context>
<context>
    <name>nmc::WorkBox</name>
    <message>
        <source>Positions count from this work offset</source>
        <translation>位置の基準となるワークオフセット</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>解除</translation>
    </message>
    <message>
        <source>Clear work offset: positions count by the counter</source>
        <translation>解除：位置はカウンター値になります</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Delete work offset</source>
        <translation>削除：ワークオフセットを削除</translation>
    </message>
    <message>
        <source>Count from</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>Number for the present position</source>
        <translation>現在位置の値</translation>
    </message>
    <message>
        <source>What the present position is to be called, in the unit of the axis.</source>
        <translation>現在位置に与える値（軸の単位）です。</translation>
    </message>
    <message>
        <source>Name of the work offset</source>
        <translation>ワークオフセットの名前</translation>
    </message>
    <message>
        <source>The name by which you choose it later.</source>
        <translation>後で選択するときの名前です。</translation>
    </message>
    <message>
        <source>For example: fixture A</source>
        <translation>例：治具A</translation>
    </message>
    <message>
        <source>Call this position</source>
        <translation>この位置に設定</translation>
    </message>
    <message>
        <source>Call this position: make a work offset</source>
        <translation>この位置に設定：ワークオフセットを作成</translation>
    </message>
    <message>
        <source>This position is</source>
        <translation>この位置の値</translation>
    </message>
    <message>
        <source>The motor is moving. Stop it first, and call its position then.</source>
        <translation>モーターが動いています。先に停止してから位置を設定してください。</translation>
    </message>
    <message>
        <source>Enter a name for the work offset, for example of a fixture.</source>
        <translation>ワークオフセットの名前（治具の名前など）を入力してください。</translation>
    </message>
    <message>
        <source>Another work offset of this axis has this name. Delete that one, or enter another name.</source>
        <translation>この軸の別のワークオフセットが同じ名前です。それを削除するか、別の名前を入力してください。</translation>
    </message>
    <message>
        <source>This axis has as many work offsets as it can have. Delete one first.</source>
        <translation>この軸のワークオフセットは上限に達しています。先に1つ削除してください。</translation>
    </message>
    <message>
        <source>With this number, the work offset would be outside the position range.</source>
        <translation>この値では、ワークオフセットが位置の範囲外になります。</translation>
    </message>
    <message>
        <source>the counter</source>
        <translation>カウンター</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1：不明</translation>
    </message>
    <message>
        <source>Where the positions on the screen count from. Nothing moves, and nothing is sent.</source>
        <translation>画面上の位置の基準です。何も動かず、何も送信されません。</translation>
    </message>
    <message>
        <source>No work offset is in use.</source>
        <translation>ワークオフセットは使用されていません。</translation>
    </message>
    <message>
        <source>Positions count by the counter again. Nothing moves.</source>
        <translation>位置は再びカウンター値になります。何も動きません。</translation>
    </message>
    <message>
        <source>Choose the work offset first.</source>
        <translation>先にワークオフセットを選択してください。</translation>
    </message>
    <message>
        <source>Deletes the work offset from the machine. Nothing moves.</source>
        <translation>ワークオフセットを装置から削除します。何も動きません。</translation>
    </message>
    <message>
        <source>Positions then count from there. Nothing moves; counter and home stay.</source>
        <translation>位置はそこから数えます。何も動かず、カウンターと原点はそのままです。</translation>
    </message>
    <message>
        <source>Home is unknown: an offset lasts only until home or the counter changes, and is not kept.</source>
        <translation>原点が不明です：オフセットは原点またはカウンターが変わるまで有効で、保存されません。</translation>
    </message>
</context>
<context>
    <name>nmc::XyDialog</name>
    <message>
        <source>One signal over another, between the cursors</source>
        <translation>カーソル間の、ある信号対別の信号</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>横軸</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>縦軸</translation>
    </message>
    <message>
        <source>&amp;Horizontal</source>
        <translation>横軸(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Vertical</source>
        <translation>縦軸(&amp;V)</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%2に対する%1</translation>
    </message>
</context>
<context>
    <name>nmc::XyPlot</name>
    <message>
        <source>One signal over another</source>
        <translation>ある信号対別の信号</translation>
    </message>
    <message>
        <source>Each sample of the vertical signal, over the value of the horizontal one at the same time. The dot marks the last one. Double-click to show everything. Scroll to zoom horizontally, or vertically with Ctrl; drag to pan.</source>
        <translation>縦軸の信号の各サンプルを、同じ時刻の横軸の信号の値に対して表示します。点は最後のサンプルです。ダブルクリックで全体を表示します。スクロールで横方向を、Ctrlを押しながらで縦方向を拡大縮小し、ドラッグで表示を移動します。</translation>
    </message>
</context>
</TS>
