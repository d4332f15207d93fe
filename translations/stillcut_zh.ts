<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>Core</name>
    <message>
        <source>High-pass edge</source>
        <translation>高通截止</translation>
    </message>
    <message>
        <source>Removes offset and drift below this frequency; auto: a quarter of the spindle frequency</source>
        <translation>去除此频率以下的偏置和漂移；自动：主轴频率的四分之一</translation>
    </message>
    <message>
        <source>Doubt of the told speed</source>
        <translation>给定转速的误差</translation>
    </message>
    <message>
        <source>How far the told spindle speed may be from the true one, as a ratio; searched at entry</source>
        <translation>给定转速与真实转速的允许偏差（比值）；切入时搜索</translation>
    </message>
    <message>
        <source>Cut above air</source>
        <translation>切削高于空切</translation>
    </message>
    <message>
        <source>A cut is this much louder than the quietest the sensor has heard</source>
        <translation>切削比传感器听到的最安静时响这么多</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>谐波数</translation>
    </message>
    <message>
        <source>Spindle harmonics of the periodic part (L, eq. 9); auto: 32 as the rate allows</source>
        <translation>周期部分的主轴谐波数（L，式 9）；自动：采样率允许时为 32</translation>
    </message>
    <message>
        <source>NLMS step</source>
        <translation>NLMS 步长</translation>
    </message>
    <message>
        <source>mu of eq. 19; auto: a memory of two turns (paper: 0.5)</source>
        <translation>式 19 的 mu；自动：两转的记忆（论文：0.5）</translation>
    </message>
    <message>
        <source>NLMS leak</source>
        <translation>NLMS 泄漏</translation>
    </message>
    <message>
        <source>lambda of eq. 19; auto: leaves 1 % of a harmonic (paper: 0.9995)</source>
        <translation>式 19 的 lambda；自动：保留谐波的 1 %（论文：0.9995）</translation>
    </message>
    <message>
        <source>AR drift</source>
        <translation>AR 漂移</translation>
    </message>
    <message>
        <source>R_v of eq. 21, for a signal of unit variance</source>
        <translation>式 21 的 R_v，针对单位方差信号</translation>
    </message>
    <message>
        <source>AR noise</source>
        <translation>AR 噪声</translation>
    </message>
    <message>
        <source>R_w of eq. 21, for a signal of unit variance</source>
        <translation>式 21 的 R_w，针对单位方差信号</translation>
    </message>
    <message>
        <source>Reflected distance</source>
        <translation>反射距离</translation>
    </message>
    <message>
        <source>Distance from the unit circle at which an unstable root is put back inside</source>
        <translation>不稳定根放回单位圆内时与圆的距离</translation>
    </message>
    <message>
        <source>Working rate</source>
        <translation>工作采样率</translation>
    </message>
    <message>
        <source>Least rate the method works at; auto: 10 kHz, as the paper</source>
        <translation>方法的最低采样率；自动：10 kHz，同论文</translation>
    </message>
    <message>
        <source>Variance limit</source>
        <translation>方差限值</translation>
    </message>
    <message>
        <source>Variance of the residual (squared unit of the sensor) that is an alarm; auto: growth above the learned floor</source>
        <translation>触发报警的残差方差（传感器单位平方）；自动：高于学习的本底</translation>
    </message>
    <message>
        <source>Root of an alarm</source>
        <translation>报警根模</translation>
    </message>
    <message>
        <source>Magnitude of the dominant root below which the residual is noise and not chatter</source>
        <translation>主导根的模低于此值时残差为噪声而非颤振</translation>
    </message>
    <message>
        <source>Evidence for onset</source>
        <translation>开始证据</translation>
    </message>
    <message>
        <source>Log-likelihood ratio of growth against the learned floor that makes an onset (onset_test.h)</source>
        <translation>判为开始的增长对本底的对数似然比（onset_test.h）</translation>
    </message>
    <message>
        <source>Chatter ratio</source>
        <translation>颤振比</translation>
    </message>
    <message>
        <source>Energy ratio from which a cut is in full chatter</source>
        <translation>达到此能量比即为完全颤振</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Length of the spectrum; auto: 28 turns, at most 1.5 s (paper: 0.512 s)</source>
        <translation>频谱长度；自动：28 转，最多 1.5 s（论文：0.512 s）</translation>
    </message>
    <message>
        <source>Spectra per window</source>
        <translation>每窗频谱数</translation>
    </message>
    <message>
        <source>A new spectrum is taken this often within one window</source>
        <translation>一个窗口内取频谱的次数</translation>
    </message>
    <message>
        <source>Line threshold</source>
        <translation>谱线阈值</translation>
    </message>
    <message>
        <source>Amplitude (unit of the sensor) of a line that is chatter; auto: growth above the learned floor</source>
        <translation>判为颤振的谱线幅值（传感器单位）；自动：高于学习的本底</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>掩蔽</translation>
    </message>
    <message>
        <source>Half width of the mask on a harmonic, in bins</source>
        <translation>谐波掩蔽的半宽（谱线数）</translation>
    </message>
    <message>
        <source>Purity</source>
        <translation>纯度</translation>
    </message>
    <message>
        <source>Part of the power between the harmonics that a chatter line holds at least</source>
        <translation>颤振谱线至少占谐波间功率的份额</translation>
    </message>
    <message>
        <source>Spindle harmonics the Kalman filter removes (N, eq. 16); auto: 12 tooth passings, at least 32, as the sampling rate allows</source>
        <translation>卡尔曼滤波去除的主轴谐波数（N，式 16）；自动：12 次齿通，至少 32，视采样率而定</translation>
    </message>
    <message>
        <source>Process noise ratio</source>
        <translation>过程噪声比</translation>
    </message>
    <message>
        <source>Q/R of the Kalman filter (eq. 20); auto: a memory of two turns</source>
        <translation>卡尔曼滤波的 Q/R（式 20）；自动：两转的记忆</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>协方差</translation>
    </message>
    <message>
        <source>Covariance of the Kalman filter: its settled gain from the start, or eq. 20 at every sample, which is right from the first turn on and costs some twenty times as much</source>
        <translation>卡尔曼滤波协方差：一开始即用稳态增益，或每个采样用式 20（从第一转起即正确，但代价约二十倍）</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>稳态</translation>
    </message>
    <message>
        <source>full</source>
        <translation>完整</translation>
    </message>
    <message>
        <source>Smallest onset</source>
        <translation>最小开始</translation>
    </message>
    <message>
        <source>Unrepeated vibration over all vibration (amplitudes) below which growth is not yet called onset</source>
        <translation>非周期振动占全部振动（幅值）低于此值时增长不算开始</translation>
    </message>
    <message>
        <source>Log-likelihood ratio of growth against the learned noise that makes an onset; a stable cut lasts e to this power turns, on average, without a false alarm</source>
        <translation>判为开始的增长对噪声的对数似然比；稳定切削平均可转 e 的该次方转而无误报</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>相干性</translation>
    </message>
    <message>
        <source>welch: averaged magnitude-squared coherence; paper: eq. 3-5 of one transform</source>
        <translation>welch：平均的幅值平方相干；paper：单次变换的式 3-5</translation>
    </message>
    <message>
        <source>welch</source>
        <translation>Welch</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>论文原式</translation>
    </message>
    <message>
        <source>Sharpening</source>
        <translation>锐化</translation>
    </message>
    <message>
        <source>Weighting of the smoothed coherence; printed: eq. 3-17b as it stands</source>
        <translation>平滑相干的加权；printed：按原样用式 3-17b</translation>
    </message>
    <message>
        <source>monotone</source>
        <translation>单调</translation>
    </message>
    <message>
        <source>printed</source>
        <translation>原式</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>分段</translation>
    </message>
    <message>
        <source>Length of one transform; auto: 12 turns, at most 1 s</source>
        <translation>单次变换的长度；自动：12 转，最多 1 s</translation>
    </message>
    <message>
        <source>Averages</source>
        <translation>平均次数</translation>
    </message>
    <message>
        <source>Memory of the averages, in segments (each overlaps the last by 7/8)</source>
        <translation>平均的记忆，以分段计（相邻重叠 7/8）</translation>
    </message>
    <message>
        <source>Window from</source>
        <translation>窗口起点</translation>
    </message>
    <message>
        <source>Where the window of eq. 3-18 begins to rise (paper: 170 Hz); auto: no window</source>
        <translation>式 3-18 窗口开始上升处（论文：170 Hz）；自动：无窗口</translation>
    </message>
    <message>
        <source>Window to</source>
        <translation>窗口终点</translation>
    </message>
    <message>
        <source>Where the window of eq. 3-18 has fallen (paper: 250 Hz); auto: no window</source>
        <translation>式 3-18 窗口下降完毕处（论文：250 Hz）；自动：无窗口</translation>
    </message>
    <message>
        <source>Coherence reference</source>
        <translation>相干基准</translation>
    </message>
    <message>
        <source>gamma_ref: coherence ratio that is chatter&apos;s</source>
        <translation>gamma_ref：表示颤振的相干比</translation>
    </message>
    <message>
        <source>Energy reference</source>
        <translation>能量基准</translation>
    </message>
    <message>
        <source>E_ref (unit of the sensor) of eq. 3-21; auto: growth above the learned floor</source>
        <translation>式 3-21 的 E_ref（传感器单位）；自动：高于学习的本底</translation>
    </message>
    <message>
        <source>Part of the cross spectrum between the harmonics that a chatter line holds at least</source>
        <translation>颤振谱线至少占谐波间互谱的份额</translation>
    </message>
    <message>
        <source>Confirmation</source>
        <translation>确认时间</translation>
    </message>
    <message>
        <source>How long an alarm stands at one frequency before the first move</source>
        <translation>首次动作前报警在同一频率持续的时间</translation>
    </message>
    <message>
        <source>Confirmation after a move</source>
        <translation>动作后的确认</translation>
    </message>
    <message>
        <source>How long chatter stands at the new speed before that speed is given up</source>
        <translation>新转速下颤振持续多久后放弃该转速</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>稳定时间</translation>
    </message>
    <message>
        <source>After the spindle has reached a new speed it is judged no sooner</source>
        <translation>主轴到达新转速后至少等待此时间再结论</translation>
    </message>
    <message>
        <source>Speeds to try</source>
        <translation>尝试转速数</translation>
    </message>
    <message>
        <source>After so many speeds without quiet it goes back and advises only</source>
        <translation>试过这么多转速仍不平稳则返回并仅建议</translation>
    </message>
    <message>
        <source>Memory of tried speeds</source>
        <translation>已试转速的记忆</translation>
    </message>
    <message>
        <source>After so long without an alarm the tried speeds are forgotten</source>
        <translation>这么久无报警后忘记已试转速</translation>
    </message>
    <message>
        <source>Pause after giving up</source>
        <translation>放弃后的暂停</translation>
    </message>
    <message>
        <source>So long nothing is tried again after no speed was quiet</source>
        <translation>无平稳转速后这么久不再尝试</translation>
    </message>
    <message>
        <source>Smoothing of the frequency</source>
        <translation>频率平滑</translation>
    </message>
    <message>
        <source>Time constant of the low-pass on the chatter frequency</source>
        <translation>颤振频率低通的时间常数</translation>
    </message>
    <message>
        <source>Act on</source>
        <translation>动作时机</translation>
    </message>
    <message>
        <source>Move at the onset of chatter, or only when it is full chatter</source>
        <translation>在颤振开始时动作，或仅在完全颤振时动作</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>颤振</translation>
    </message>
    <message>
        <source>Freeze when quiet</source>
        <translation>平稳时冻结</translation>
    </message>
    <message>
        <source>Stay at the actual speed once chatter clears, for narrow lobes, instead of going on to the last target</source>
        <translation>颤振消失后停在实际转速（适于窄稳定区），而不继续到最后目标</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>mu_c of eq. 32</source>
        <translation>式 32 的 mu_c</translation>
    </message>
    <message>
        <source>Smoothing of the level</source>
        <translation>水平平滑</translation>
    </message>
    <message>
        <source>lambda_c of eq. 33</source>
        <translation>式 33 的 lambda_c</translation>
    </message>
    <message>
        <source>Unit of a step</source>
        <translation>步的单位</translation>
    </message>
    <message>
        <source>What a step of 1 in eq. 32 is, in percent of the programmed speed</source>
        <translation>式 32 中步长 1 对应编程转速的百分比</translation>
    </message>
    <message>
        <source>Control period</source>
        <translation>控制周期</translation>
    </message>
    <message>
        <source>Time from one step of eq. 32 to the next</source>
        <translation>式 32 相邻两步的时间</translation>
    </message>
    <message>
        <source>Step of the search</source>
        <translation>搜索步长</translation>
    </message>
    <message>
        <source>Distance of neighbouring trials, in percent of the programmed speed</source>
        <translation>相邻尝试的间距，占编程转速的百分比</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Speeds to choose from: the nearest, only lower, only higher</source>
        <translation>可选转速：最近、仅更低、仅更高</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>down</source>
        <translation>更低</translation>
    </message>
    <message>
        <source>up</source>
        <translation>更高</translation>
    </message>
    <message>
        <source>Phase factor</source>
        <translation>相位因子</translation>
    </message>
    <message>
        <source>Fraction of a wave left between two cuts (nu of eq. 3)</source>
        <translation>两次切削之间剩余的波数（式 3 的 nu）</translation>
    </message>
    <message>
        <source>Control cycle</source>
        <translation>控制循环</translation>
    </message>
    <message>
        <source>Speed and feed are changed once per cycle</source>
        <translation>转速和进给每循环改变一次</translation>
    </message>
    <message>
        <source>Time for the whole range</source>
        <translation>全程时间</translation>
    </message>
    <message>
        <source>At full output the whole range of an override takes this long (the paper&apos;s limit: a second)</source>
        <translation>满输出时走完倍率全程所需时间（论文限值：一秒）</translation>
    </message>
    <message>
        <source>Coherence above which speed and feed fall (gamma_ref)</source>
        <translation>超过此相干时转速和进给下降（gamma_ref）</translation>
    </message>
    <message>
        <source>Vibration over that of the stable cut above which speed and feed fall</source>
        <translation>振动与稳定切削之比超过此值时转速和进给下降</translation>
    </message>
    <message>
        <source>Energy limit</source>
        <translation>能量限值</translation>
    </message>
    <message>
        <source>Vibration over that of the stable cut at which the feed goes to its lowest; at twice that the feed is held</source>
        <translation>振动与稳定切削之比达此值时进给降至最低；两倍时进给保持</translation>
    </message>
    <message>
        <source>Highest overrides</source>
        <translation>最高倍率</translation>
    </message>
    <message>
        <source>Speed and feed rise no further than this fraction of the programmed values</source>
        <translation>转速和进给最多升至编程值的此比例</translation>
    </message>
    <message>
        <source>Rest of the speed</source>
        <translation>转速静止</translation>
    </message>
    <message>
        <source>The speed does not rise for so long after an alarm</source>
        <translation>报警后这么久转速不上升</translation>
    </message>
    <message>
        <source>Learning weight</source>
        <translation>学习权重</translation>
    </message>
    <message>
        <source>Share of the coherence error that the rules learn (w of eq. 3-32)</source>
        <translation>规则学习的相干误差份额（式 3-32 的 w）</translation>
    </message>
    <message>
        <source>Direct tuning</source>
        <translation>直接整定</translation>
    </message>
    <message>
        <source>By coherence alone (eq. 3-37) or by coherence and energy (3-36)</source>
        <translation>仅按相干（式 3-37）或按相干与能量（3-36）</translation>
    </message>
    <message>
        <source>single</source>
        <translation>单项</translation>
    </message>
    <message>
        <source>double</source>
        <translation>双项</translation>
    </message>
    <message>
        <source>Coherence weight</source>
        <translation>相干权重</translation>
    </message>
    <message>
        <source>Weight of the coherence error (w_gamma of eq. 3-34)</source>
        <translation>相干误差权重（式 3-34 的 w_gamma）</translation>
    </message>
    <message>
        <source>Energy weight</source>
        <translation>能量权重</translation>
    </message>
    <message>
        <source>Weight of the energy error (w_E of eq. 3-35)</source>
        <translation>能量误差权重（式 3-35 的 w_E）</translation>
    </message>
    <message>
        <source>Lowest speed override</source>
        <translation>最低转速倍率</translation>
    </message>
    <message>
        <source>Spindle speed is never driven below this fraction of the programmed speed</source>
        <translation>转速不会低于编程转速的此比例</translation>
    </message>
    <message>
        <source>Highest speed override</source>
        <translation>最高转速倍率</translation>
    </message>
    <message>
        <source>Spindle speed is never driven above this fraction of the programmed speed</source>
        <translation>转速不会高于编程转速的此比例</translation>
    </message>
    <message>
        <source>Lowest feed override</source>
        <translation>最低进给倍率</translation>
    </message>
    <message>
        <source>Feed is never driven below this fraction of the programmed feed</source>
        <translation>进给不会低于编程进给的此比例</translation>
    </message>
    <message>
        <source>Highest feed override</source>
        <translation>最高进给倍率</translation>
    </message>
    <message>
        <source>Feed is never driven above this fraction of the programmed feed</source>
        <translation>进给不会高于编程进给的此比例</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>最低转速</translation>
    </message>
    <message>
        <source>Spindle speed is never driven below this; auto: no such limit</source>
        <translation>转速不会低于此值；自动：无此限值</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最高转速</translation>
    </message>
    <message>
        <source>Spindle speed is never driven above this: the machine&apos;s limit; auto: none</source>
        <translation>转速不会高于此值：机床极限；自动：无</translation>
    </message>
    <message>
        <source>Highest speed of the tool</source>
        <translation>刀具最高转速</translation>
    </message>
    <message>
        <source>What the maker allows the tool; auto: no such limit</source>
        <translation>制造商允许的刀具转速；自动：无此限值</translation>
    </message>
    <message>
        <source>Highest speed of the holder</source>
        <translation>刀柄最高转速</translation>
    </message>
    <message>
        <source>What holder and balancing allow; auto: no such limit</source>
        <translation>刀柄与动平衡允许的转速；自动：无此限值</translation>
    </message>
    <message>
        <source>Highest cutting speed</source>
        <translation>最高切削速度</translation>
    </message>
    <message>
        <source>The edge is never driven faster than this; needs the tool&apos;s diameter; auto: no such limit</source>
        <translation>切削刃不会快于此值；需要刀具直径；自动：无此限值</translation>
    </message>
    <message>
        <source>Lowest feed</source>
        <translation>最低进给</translation>
    </message>
    <message>
        <source>Feed is never driven below this; auto: no such limit</source>
        <translation>进给不会低于此值；自动：无此限值</translation>
    </message>
    <message>
        <source>Highest feed</source>
        <translation>最高进给</translation>
    </message>
    <message>
        <source>Feed is never driven above this; auto: no such limit</source>
        <translation>进给不会高于此值；自动：无此限值</translation>
    </message>
    <message>
        <source>Lowest feed per tooth</source>
        <translation>最低每齿进给</translation>
    </message>
    <message>
        <source>Our overrides never lower the feed per tooth below this fraction of the programmed one: the edge would rub</source>
        <translation>倍率不会使每齿进给低于编程值的此比例：否则刃口会摩擦</translation>
    </message>
    <message>
        <source>Highest feed per tooth</source>
        <translation>最高每齿进给</translation>
    </message>
    <message>
        <source>Our overrides never raise the feed per tooth above this fraction of the programmed one</source>
        <translation>倍率不会使每齿进给高于编程值的此比例</translation>
    </message>
    <message>
        <source>Speed change per step</source>
        <translation>每步转速变化</translation>
    </message>
    <message>
        <source>Largest change of the speed override in one step of the gate, in percent of the programmed speed</source>
        <translation>闸门每步转速倍率的最大变化，占编程转速的百分比</translation>
    </message>
    <message>
        <source>Speed change per second</source>
        <translation>每秒转速变化</translation>
    </message>
    <message>
        <source>Fastest change of the speed override, in percent of the programmed speed per second</source>
        <translation>转速倍率的最快变化，每秒占编程转速的百分比</translation>
    </message>
    <message>
        <source>Feed change per step</source>
        <translation>每步进给变化</translation>
    </message>
    <message>
        <source>Largest change of the feed override in one step of the gate, in percent of the programmed feed</source>
        <translation>闸门每步进给倍率的最大变化，占编程进给的百分比</translation>
    </message>
    <message>
        <source>Feed change per second</source>
        <translation>每秒进给变化</translation>
    </message>
    <message>
        <source>Fastest change of the feed override, in percent of the programmed feed per second</source>
        <translation>进给倍率的最快变化，每秒占编程进给的百分比</translation>
    </message>
    <message>
        <source>Recovery rate</source>
        <translation>恢复速率</translation>
    </message>
    <message>
        <source>Rate of the way back toward 100 % when nothing chatters, as a share of the rate away from it</source>
        <translation>无颤振时返回 100 % 的速率，占离开速率的比例</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Time constant of the low-pass on the wanted overrides</source>
        <translation>期望倍率低通的时间常数</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>死区</translation>
    </message>
    <message>
        <source>Wanted changes up to this are not worth moving the machine</source>
        <translation>不超过此值的期望变化不值得动机床</translation>
    </message>
    <message>
        <source>Changes per minute</source>
        <translation>每分钟变化次数</translation>
    </message>
    <message>
        <source>Moves that start from rest or turn back, at most so many in any minute</source>
        <translation>每分钟从静止开始或反向的动作最多次数</translation>
    </message>
    <message>
        <source>Cool-down</source>
        <translation>冷却时间</translation>
    </message>
    <message>
        <source>Pause after the changes per minute are used up; the second time Auto falls back to Advise</source>
        <translation>每分钟次数用尽后的暂停；第二次则由自动退回建议</translation>
    </message>
    <message>
        <source>Speed tolerance</source>
        <translation>转速容差</translation>
    </message>
    <message>
        <source>The spindle counts as at speed, and an override as taken, within this</source>
        <translation>在此范围内视为主轴到速、倍率已接受</translation>
    </message>
    <message>
        <source>Machine state age</source>
        <translation>机床状态时效</translation>
    </message>
    <message>
        <source>Verdict age</source>
        <translation>结论时效</translation>
    </message>
    <message>
        <source>A verdict or request older than this is stale</source>
        <translation>早于此的结论或请求视为过时</translation>
    </message>
    <message>
        <source>Hold before release</source>
        <translation>释放前保持</translation>
    </message>
    <message>
        <source>On bad input the overrides are held this long, then the programmed values come back</source>
        <translation>输入不良时倍率保持此时间，然后恢复编程值</translation>
    </message>
    <message>
        <source>Rest after release</source>
        <translation>释放后静止</translation>
    </message>
    <message>
        <source>After a release the input must be good for this long before the overrides are taken again</source>
        <translation>释放后输入须良好这么久才再次接管倍率</translation>
    </message>
    <message>
        <source>Pause after the knob</source>
        <translation>旋钮后的暂停</translation>
    </message>
    <message>
        <source>After the operator turned a knob nothing new is asked this long</source>
        <translation>操作者调旋钮后这么久不提新请求</translation>
    </message>
    <message>
        <source>Time to take an override</source>
        <translation>接受倍率的时间</translation>
    </message>
    <message>
        <source>The override read back must agree with the command within this, or the machine is let go</source>
        <translation>回读倍率须在此时间内与指令一致，否则放开机床</translation>
    </message>
    <message>
        <source>Time for the spindle to follow</source>
        <translation>主轴跟随时间</translation>
    </message>
    <message>
        <source>The spindle must reach the commanded speed within this, or the machine is let go</source>
        <translation>主轴须在此时间内到达指令转速，否则放开机床</translation>
    </message>
    <message>
        <source>Lease</source>
        <translation>租约</translation>
    </message>
    <message>
        <source>A command that is not renewed within this ends, and the programmed values come back</source>
        <translation>指令在此时间内未续期即终止，恢复编程值</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>What is kept: everything, what surrounds events, or verdicts and indicators alone</source>
        <translation>保存内容：全部、事件前后、或仅结论与指标</translation>
    </message>
    <message>
        <source>continuous</source>
        <translation>连续</translation>
    </message>
    <message>
        <source>around-events</source>
        <translation>事件前后</translation>
    </message>
    <message>
        <source>features</source>
        <translation>特征</translation>
    </message>
    <message>
        <source>Kept before an event</source>
        <translation>事件前保留</translation>
    </message>
    <message>
        <source>Around events: how much is kept from before each</source>
        <translation>事件前后：每个事件之前保留多少</translation>
    </message>
    <message>
        <source>Kept after an event</source>
        <translation>事件后保留</translation>
    </message>
    <message>
        <source>Around events: how long recording goes on after the last</source>
        <translation>事件前后：最后事件之后继续记录多久</translation>
    </message>
    <message>
        <source>Step of the history</source>
        <translation>历史步长</translation>
    </message>
    <message>
        <source>Features: one step is kept in so long, and every one with an event</source>
        <translation>特征：每隔此时间保留一步，有事件的步全部保留</translation>
    </message>
    <message>
        <source>Length of the history</source>
        <translation>历史长度</translation>
    </message>
    <message>
        <source>Features: what is older goes</source>
        <translation>特征：更早的删除</translation>
    </message>
    <message>
        <source>Keep recordings for</source>
        <translation>记录保留时间</translation>
    </message>
    <message>
        <source>Older recordings without a marker are deleted when a new one begins</source>
        <translation>新记录开始时删除更早的无标记记录</translation>
    </message>
    <message>
        <source>Keep recordings up to</source>
        <translation>记录保留容量</translation>
    </message>
    <message>
        <source>The oldest recordings without a marker are deleted beyond it</source>
        <translation>超过时删除最早的无标记记录</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>反馈</translation>
    </message>
    <message>
        <source>In simulation: what is to fall, vibration by the accelerometers or the force at the spindle&apos;s frequency</source>
        <translation>仿真中：要减小的量，加速度计测得的振动，或主轴频率处的力</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Taps</source>
        <translation>抽头数</translation>
    </message>
    <message>
        <source>Length of the adaptive filter of each axis (Ford 2013 table 3: 35)</source>
        <translation>每轴自适应滤波器长度（Ford 2013 表 3:35）</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Adaptation step mu; while &apos;normalised&apos; is on, as a fraction of the largest stable step</source>
        <translation>自适应步长 mu；归一化开启时为最大稳定步长的比例</translation>
    </message>
    <message>
        <source>Normalised</source>
        <translation>归一化</translation>
    </message>
    <message>
        <source>Take the step as a fraction of the bound that follows the power of the filtered reference</source>
        <translation>步长取为随滤波参考功率变化的界限的比例</translation>
    </message>
    <message>
        <source>Leak</source>
        <translation>泄漏</translation>
    </message>
    <message>
        <source>Factor on the weights at each sample (gamma of eq. 2); 1 forgets nothing</source>
        <translation>每个采样对权值的因子（式 2 的 gamma）；1 为不遗忘</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>What the filter works from: the error itself, or the disturbance as the model sees it</source>
        <translation>滤波器的输入：误差本身，或模型所见的扰动</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>internal-model</source>
        <translation>内模</translation>
    </message>
    <message>
        <source>Path taps</source>
        <translation>通路抽头数</translation>
    </message>
    <message>
        <source>Length of each part of the recursive model from actuator to sensor (table 3: 35)</source>
        <translation>执行器到传感器递归模型各部分的长度（表 3:35）</translation>
    </message>
    <message>
        <source>Parametric</source>
        <translation>参数法</translation>
    </message>
    <message>
        <source>Spectral line</source>
        <translation>谱线</translation>
    </message>
    <message>
        <source>Energy ratio</source>
        <translation>能量比</translation>
    </message>
    <message>
        <source>Monitoring only</source>
        <translation>仅监测</translation>
    </message>
    <message>
        <source>Next stable pocket, checked</source>
        <translation>下一稳定区（已核对）</translation>
    </message>
    <message>
        <source>Centre of the lobe</source>
        <translation>叶瓣中心</translation>
    </message>
    <message>
        <source>Toward less vibration</source>
        <translation>趋向更小振动</translation>
    </message>
    <message>
        <source>Least vibration</source>
        <translation>最小振动</translation>
    </message>
    <message>
        <source>Quarter wave between teeth</source>
        <translation>齿间四分之一波</translation>
    </message>
    <message>
        <source>Fuzzy speed and feed</source>
        <translation>模糊转速与进给</translation>
    </message>
    <message>
        <source>Fuzzy, learning its rules</source>
        <translation>模糊，自学习规则</translation>
    </message>
    <message>
        <source>Fuzzy, outputs tuned directly</source>
        <translation>模糊，直接整定输出</translation>
    </message>
    <message>
        <source>The control of the simulated mill; the only one that takes commands from a replay</source>
        <translation>模拟铣床的控制；唯一接受回放指令者</translation>
    </message>
    <message>
        <source>LinuxCNC through linuxcncrsh and halrmt: host, port, hal_port</source>
        <translation>LinuxCNC，经 linuxcncrsh 和 halrmt：host、port、hal_port</translation>
    </message>
    <message>
        <source>GRBL 1.1 or grblHAL on a serial port or a host: device, baud; host, port</source>
        <translation>GRBL 1.1 或 grblHAL，经串口或主机：device、baud；host、port</translation>
    </message>
    <message>
        <source>A spindle drive or PLC by Modbus TCP or RTU: map, a file of registers</source>
        <translation>经 Modbus TCP 或 RTU 的主轴驱动或 PLC：map，寄存器文件</translation>
    </message>
    <message>
        <source>Override voltages through a Comedi card: map, a file of calibration tables</source>
        <translation>经 Comedi 卡的倍率电压：map，标定表文件</translation>
    </message>
    <message>
        <source>A simulated cut from a scenario file, in real time or as fast as possible</source>
        <translation>来自场景文件的模拟切削，实时或尽快</translation>
    </message>
    <message>
        <source>Audio-class: measurement microphones, USB accelerometers, IEPE conditioners: device, rate_hz, bits, inputs</source>
        <translation>音频类设备：测量传声器、USB 加速度计、IEPE 调理器：device、rate_hz、bits、inputs</translation>
    </message>
    <message>
        <source>Data acquisition cards, NI and many others: device, rate_hz, range, reference, inputs</source>
        <translation>数据采集卡，NI 及许多其他型号：device、rate_hz、range、reference、inputs</translation>
    </message>
    <message>
        <source>Accelerometers of Linux&apos; industrial I/O, here or through iiod: device, rate_hz, uri, inputs, trigger</source>
        <translation>Linux 工业 I/O 加速度计，本机或经由 iiod：device、rate_hz、uri、inputs、trigger</translation>
    </message>
    <message>
        <source>A microcontroller on a serial port, binary frames or text lines: device, baud, rate_hz, format</source>
        <translation>串口上的微控制器，二进制帧或文本行：device、baud、rate_hz、format</translation>
    </message>
    <message>
        <source>Several of these as one, aligned on the clock of the first: 1_id, 1_channels, 1_delay_ms, 2_id ...</source>
        <translation>将其中几个合为一个，以第一个设备的时钟对齐：1_id、1_channels、1_delay_ms、2_id ……</translation>
    </message>
    <message>
        <source>A bridge that sends the same over a socket: host, port, rate_hz, format</source>
        <translation>通过套接字发送相同数据的网桥：host、port、rate_hz、format</translation>
    </message>
    <message>
        <source>Longest time per trial</source>
        <translation>每次试探的最长时间</translation>
    </message>
    <message>
        <source>The vibration at each trial is averaged no longer than this</source>
        <translation>每次试探时振动平均不超过这个时间</translation>
    </message>
    <message>
        <source>Revolutions per trial</source>
        <translation>每次试探的转数</translation>
    </message>
    <message>
        <source>The vibration at each trial is averaged over so many revolutions, or as long as is allowed</source>
        <translation>每次试探时振动在这么多转内平均，或到允许的最长时间</translation>
    </message>
    <message>
        <source>Signal and cut</source>
        <translation>信号与切削</translation>
    </message>
    <message>
        <source>Limits of the machine</source>
        <translation>机床极限</translation>
    </message>
    <message>
        <source>Active work-holder</source>
        <translation>主动夹具</translation>
    </message>
    <message>
        <source>Emphasis</source>
        <translation>强调</translation>
    </message>
    <message>
        <source>How much more the error counts on the lines to quieten than elsewhere, as amplitudes; 1: no more</source>
        <translation>误差在要抑制的谱线上比别处重要多少（幅值之比）；1：不更重要</translation>
    </message>
    <message>
        <source>Width of the emphasis</source>
        <translation>强调的宽度</translation>
    </message>
    <message>
        <source>Around each of the lines to quieten</source>
        <translation>在每条要抑制的谱线周围</translation>
    </message>
    <message>
        <source>Excitation</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>What moves the table while its paths are identified</source>
        <translation>辨识通道时驱动工作台的信号</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>Level of identification</source>
        <translation>辨识电平</translation>
    </message>
    <message>
        <source>Rms of the excitation, as a fraction of the stroke</source>
        <translation>激励的均方根值，占行程的比例</translation>
    </message>
    <message>
        <source>Time of identification</source>
        <translation>辨识时长</translation>
    </message>
    <message>
        <source>Length of the record it is made from</source>
        <translation>用于辨识的记录长度</translation>
    </message>
    <message>
        <source>Age of a model</source>
        <translation>模型时效</translation>
    </message>
    <message>
        <source>An older model of the path is not started with</source>
        <translation>通道模型超过此时间则不启动</translation>
    </message>
    <message>
        <source>Auxiliary noise</source>
        <translation>辅助噪声</translation>
    </message>
    <message>
        <source>Rms of the noise that identifies the path anew while it controls, as a fraction of the stroke; 0: off</source>
        <translation>控制过程中用于重新辨识通道的噪声均方根值，占行程的比例；0：关闭</translation>
    </message>
    <message>
        <source>Frames of a block</source>
        <translation>每块采样数</translation>
    </message>
    <message>
        <source>In simulation: how many samples the device takes at a time</source>
        <translation>仿真中设备每次处理的采样数</translation>
    </message>
    <message>
        <source>Peak of small</source>
        <translation>“小”的峰值</translation>
    </message>
    <message>
        <source>Where the coherence error is called small (NS, PS), of its whole range</source>
        <translation>相干误差称为“小”（NS、PS）之处，占全范围</translation>
    </message>
    <message>
        <source>Peak of medium</source>
        <translation>“中”的峰值</translation>
    </message>
    <message>
        <source>Where the coherence error is called medium (NM, PM)</source>
        <translation>相干误差称为“中”（NM、PM）之处</translation>
    </message>
    <message>
        <source>Peak of big</source>
        <translation>“大”的峰值</translation>
    </message>
    <message>
        <source>Where the coherence error is called big (NB, PB)</source>
        <translation>相干误差称为“大”（NB、PB）之处</translation>
    </message>
    <message>
        <source>Speed rule</source>
        <translation>转速规则</translation>
    </message>
    <message>
        <source>What this rule asks of the speed: 5 nothing, 1 down and 9 up at full (figure 3.7)</source>
        <translation>此规则对转速的要求：5 不变，1 全力降低，9 全力提高（图 3.7）</translation>
    </message>
    <message>
        <source>Feed rule</source>
        <translation>进给规则</translation>
    </message>
    <message>
        <source>What this rule asks of the feed: 5 nothing, 1 down and 9 up at full (figure 3.8)</source>
        <translation>此规则对进给的要求：5 不变，1 全力降低，9 全力提高（图 3.8）</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>主机</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Hal port</source>
        <translation>HAL 端口</translation>
    </message>
    <message>
        <source>Hal component port</source>
        <translation>HAL 组件端口</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>自适应进给</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>Control password</source>
        <translation>控制密码</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Reports in inches</source>
        <translation>以英寸报告</translation>
    </message>
    <message>
        <source>Ask words</source>
        <translation>查询模态字</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>映射</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>采样率</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>位数</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>16</source>
        <translation>16</translation>
    </message>
    <message>
        <source>24</source>
        <translation>24</translation>
    </message>
    <message>
        <source>32</source>
        <translation>32</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>块</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>量程</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>common</source>
        <translation>公共端</translation>
    </message>
    <message>
        <source>differential</source>
        <translation>差分</translation>
    </message>
    <message>
        <source>Uri</source>
        <translation>URI</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>binary</source>
        <translation>二进制</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Sync</source>
        <translation>同步字</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>计数器</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>u8</source>
        <translation>u8</translation>
    </message>
    <message>
        <source>u16</source>
        <translation>u16</translation>
    </message>
    <message>
        <source>u32</source>
        <translation>u32</translation>
    </message>
    <message>
        <source>Instants</source>
        <translation>每包采样时刻数</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>采样类型</translation>
    </message>
    <message>
        <source>i8</source>
        <translation>i8</translation>
    </message>
    <message>
        <source>i16</source>
        <translation>i16</translation>
    </message>
    <message>
        <source>i24</source>
        <translation>i24</translation>
    </message>
    <message>
        <source>i32</source>
        <translation>i32</translation>
    </message>
    <message>
        <source>f32</source>
        <translation>f32</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>字节序</translation>
    </message>
    <message>
        <source>little</source>
        <translation>小端</translation>
    </message>
    <message>
        <source>big</source>
        <translation>大端</translation>
    </message>
    <message>
        <source>Checksum</source>
        <translation>校验和</translation>
    </message>
    <message>
        <source>sum8</source>
        <translation>sum8</translation>
    </message>
    <message>
        <source>xor8</source>
        <translation>xor8</translation>
    </message>
    <message>
        <source>crc16</source>
        <translation>crc16</translation>
    </message>
    <message>
        <source>crc32</source>
        <translation>crc32</translation>
    </message>
    <message>
        <source>Counted</source>
        <translation>带计数</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>位移</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>声音</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>Machine in inches</source>
        <translation>机床使用英寸</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Read the machine</source>
        <translation>读取机床</translation>
    </message>
    <message>
        <source>Measure the delay</source>
        <translation>测量延迟</translation>
    </message>
    <message>
        <source>What it can do</source>
        <translation>机床能力</translation>
    </message>
    <message>
        <source>serial port, for &apos;grbl&apos; or &apos;modbus&apos;</source>
        <translation>串口，用于“grbl”或“modbus”</translation>
    </message>
    <message>
        <source>linuxcncrsh, for &apos;linuxcnc&apos;</source>
        <translation>linuxcncrsh，用于“linuxcnc”</translation>
    </message>
    <message>
        <source>halrmt, spindle speed for &apos;linuxcnc&apos;</source>
        <translation>halrmt，用于“linuxcnc”的主轴转速</translation>
    </message>
    <message>
        <source>stillcut-hal, watchdog for &apos;linuxcnc&apos;</source>
        <translation>stillcut-hal，用于“linuxcnc”的看门狗</translation>
    </message>
    <message>
        <source>Modbus server, for &apos;modbus&apos; with a map</source>
        <translation>Modbus 服务器，用于“modbus”，需寄存器表</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>needs a label</source>
        <translation>需要一个名称</translation>
    </message>
    <message>
        <source>type one beside SPAN</source>
        <translation>请在“区段”旁输入</translation>
    </message>
    <message>
        <source>export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>the recording is still being read</source>
        <translation>记录仍在读取中</translation>
    </message>
    <message>
        <source>a moment later</source>
        <translation>请稍后再试</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>无法写入</translation>
    </message>
    <message>
        <source>active work-holder</source>
        <translation>主动工作台</translation>
    </message>
    <message>
        <source>the last record is still being worked on</source>
        <translation>上一次记录仍在处理中</translation>
    </message>
    <message>
        <source>score</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>nothing is marked here</source>
        <translation>这里没有任何标记</translation>
    </message>
    <message>
        <source>mark true and false alarms first</source>
        <translation>请先标记真报警与误报警</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>there is no folder to keep it in</source>
        <translation>没有可存放的文件夹</translation>
    </message>
    <message>
        <source>letters and digits</source>
        <translation>请用字母和数字</translation>
    </message>
    <message>
        <source>cannot be put in force here</source>
        <translation>不能在这里启用</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>cannot run here</source>
        <translation>不能在这里运行</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>there is no folder to keep them in</source>
        <translation>没有可存放的文件夹</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>the device has stopped</source>
        <translation>设备已停止</translation>
    </message>
    <message>
        <source>this channel never moves</source>
        <translation>该通道始终不动</translation>
    </message>
    <message>
        <source>is the sensor connected?</source>
        <translation>传感器是否已连接？</translation>
    </message>
    <message>
        <source>nothing is open</source>
        <translation>没有打开任何文件</translation>
    </message>
    <message>
        <source>replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>is no longer there</source>
        <translation>已不存在</translation>
    </message>
    <message>
        <source>tune</source>
        <translation>调整</translation>
    </message>
    <message>
        <source>there is no profile to keep them in</source>
        <translation>没有可存放的配置</translation>
    </message>
    <message>
        <source>start with --profile</source>
        <translation>请用 --profile 启动</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>无法创建</translation>
    </message>
    <message>
        <source>start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>the machine is under our authority</source>
        <translation>机床正由 Stillcut 控制</translation>
    </message>
    <message>
        <source>set it to Off first</source>
        <translation>请先设为关闭</translation>
    </message>
    <message>
        <source>Vibration limit</source>
        <translation>振动限值</translation>
    </message>
    <message>
        <source>Vibration (rms, SI unit of the first channel) from which the bar of the operator&apos;s page says that it is too much; auto: no limit</source>
        <translation>振动（有效值，第一通道的 SI 单位）达到此值时，操作页的条形图显示超限；自动：无限值</translation>
    </message>
    <message>
        <source>%1 answers</source>
        <translation>%1 有应答</translation>
    </message>
    <message>
        <source>it answers, but its state is incomplete</source>
        <translation>有应答，但状态不完整</translation>
    </message>
    <message>
        <source>the machine is off</source>
        <translation>机床已关闭</translation>
    </message>
    <message>
        <source>the machine is in alarm</source>
        <translation>机床处于报警状态</translation>
    </message>
    <message>
        <source>feed held</source>
        <translation>进给保持</translation>
    </message>
    <message>
        <source>program running</source>
        <translation>程序正在运行</translation>
    </message>
    <message>
        <source>no program running</source>
        <translation>没有程序在运行</translation>
    </message>
    <message>
        <source>spindle %1 rpm, programmed %2</source>
        <translation>主轴 %1 rpm，编程值 %2</translation>
    </message>
    <message>
        <source>overrides %1 % speed, %2 % feed</source>
        <translation>倍率：转速 %1 %，进给 %2 %</translation>
    </message>
    <message>
        <source>locked by the program</source>
        <translation>已被程序锁定</translation>
    </message>
    <message>
        <source>a look takes %1 ms, and what it shows is %2 ms old</source>
        <translation>一次查询用时 %1 ms，所示数据为 %2 ms 前</translation>
    </message>
    <message>
        <source>%1 of %2 looks were lost</source>
        <translation>%2 次查询中丢失 %1 次</translation>
    </message>
    <message>
        <source>speed %1 to %2 %, feed %3 to %4 %</source>
        <translation>转速 %1 至 %2 %，进给 %3 至 %4 %</translation>
    </message>
    <message>
        <source>the machine goes back by itself when nothing comes from here</source>
        <translation>收不到本程序信号时机床会自行恢复</translation>
    </message>
    <message>
        <source>the machine has no watchdog: if this program dies, the overrides stay</source>
        <translation>机床没有看门狗：若本程序中止，倍率将保持不变</translation>
    </message>
    <message>
        <source>one knock along %1: &apos;%2&apos; measured most, %3 dB above the next</source>
        <translation>沿 %1 敲击一次：&apos;%2&apos; 最响，比其次高 %3 dB</translation>
    </message>
    <message>
        <source>%4 knocks along %1: &apos;%2&apos; measured most, %3 dB above the next</source>
        <translation>沿 %1 敲击 %4 次：&apos;%2&apos; 最响，比其次高 %3 dB</translation>
    </message>
    <message>
        <source>it is right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; are exchanged</source>
        <translation>&apos;%1&apos; 与 &apos;%2&apos; 接反了</translation>
    </message>
    <message>
        <source>A recording, in real time or at another pace: file, pace, rate_hz where the file does not say</source>
        <translation>一段记录，按实时或其他速度播放：file、pace，文件未给出时还有 rate_hz</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>the device counts nothing: a loss of less than 30 ms or three blocks does not show, a longer one after a second or two</source>
        <translation>该设备不计数：少于 30 毫秒或三个数据块的丢失无法发现，更长的丢失在一两秒后发现</translation>
    </message>
    <message>
        <source>the card is not calibrated, its volts are nominal; comedi_soft_calibrate calibrates it</source>
        <translation>采集卡未校准，其电压为标称值；可用 comedi_soft_calibrate 校准</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>is it there, and free?</source>
        <translation>设备是否存在且未被占用？</translation>
    </message>
    <message>
        <source>nothing is sent</source>
        <translation>没有收到任何数据</translation>
    </message>
    <message>
        <source>does the device stream?</source>
        <translation>设备是否在发送数据？</translation>
    </message>
    <message>
        <source>bytes come, and no sample of the [[channels]] is in them</source>
        <translation>收到字节，但其中没有 [[channels]] 的采样</translation>
    </message>
    <message>
        <source>are format, sync, sample, checksum, baud and the number of channels those of the sender?</source>
        <translation>format、sync、sample、checksum、baud 和通道数是否与发送方一致？</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>没有应答</translation>
    </message>
    <message>
        <source>does not stream</source>
        <translation>不输出数据流</translation>
    </message>
    <message>
        <source>does not start</source>
        <translation>无法启动</translation>
    </message>
    <message>
        <source>has no inputs that stream</source>
        <translation>没有可连续采集的输入</translation>
    </message>
    <message>
        <source>it may read single values only</source>
        <translation>可能只能读取单个数值</translation>
    </message>
    <message>
        <source>it only shares its memory</source>
        <translation>它只共享其内存</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>does not take these settings together</source>
        <translation>不接受这些设置的组合</translation>
    </message>
    <message>
        <source>has not delivered enough in one piece</source>
        <translation>没有连续提供足够的数据</translation>
    </message>
    <message>
        <source>the device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>%1 Hz cannot be measured at %2 samples a second</source>
        <translation>采样率为每秒 %2 点时听不到 %1 Hz</translation>
    </message>
    <message>
        <source>%1 MB are left</source>
        <translation>剩余 %1 MB</translation>
    </message>
    <message>
        <source>%1 [[channels]] in the profile</source>
        <translation>配置文件中有 %1 个 [[channels]]</translation>
    </message>
    <message>
        <source>%1 and %2 frames</source>
        <translation>%1 和 %2 帧</translation>
    </message>
    <message>
        <source>%1 at %2: nothing comes any more, the wire is taken up again</source>
        <translation>%1（%2）：不再有数据，正在重新连接</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 无法读取</translation>
    </message>
    <message>
        <source>%1 has no higher voltage</source>
        <translation>%1 的电压没有升高</translation>
    </message>
    <message>
        <source>%1 is longer than the file</source>
        <translation>%1 比文件还长</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 不是有限数</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 不是整数</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 超出范围</translation>
    </message>
    <message>
        <source>%1 is too large for a sample</source>
        <translation>%1 作为采样值过大</translation>
    </message>
    <message>
        <source>%1 mm is no depth</source>
        <translation>%1 mm 不是有效切深</translation>
    </message>
    <message>
        <source>%1 of %2 bytes are there; copy it again</source>
        <translation>只有 %2 字节中的 %1 字节；请重新复制</translation>
    </message>
    <message>
        <source>%1 rpm is no speed</source>
        <translation>%1 rpm 不是有效转速</translation>
    </message>
    <message>
        <source>%1 rpm is too low for these modes</source>
        <translation>%1 rpm 对这些模态过低</translation>
    </message>
    <message>
        <source>%1 turns the table round</source>
        <translation>%1 使表格反向</translation>
    </message>
    <message>
        <source>%1, device %2: %3</source>
        <translation>%1，设备 %2：%3</translation>
    </message>
    <message>
        <source>%1: %2 failed (%3)</source>
        <translation>%1：%2 失败（%3）</translation>
    </message>
    <message>
        <source>%1: a length inside it is wrong</source>
        <translation>%1：其中有错误的长度</translation>
    </message>
    <message>
        <source>%1: is not the device that it was</source>
        <translation>%1：已不是原来的设备</translation>
    </message>
    <message>
        <source>%1; some devices need a &apos;trigger&apos;</source>
        <translation>%1；有些设备需要 &apos;trigger&apos;</translation>
    </message>
    <message>
        <source>%1; stillcut-cli devices lists what there is</source>
        <translation>%1；stillcut-cli devices 可列出现有设备</translation>
    </message>
    <message>
        <source>%1; the cut before has been stopped</source>
        <translation>%1；之前的切削已停止</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; measured it within %3 dB of each other</source>
        <translation>&apos;%1&apos; 与 &apos;%2&apos; 听到的相差不到 %3 dB</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be opened</source>
        <translation>&apos;%1&apos; 无法打开</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read</source>
        <translation>&apos;%1&apos; 无法读取</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no other axis beside it</source>
        <translation>&apos;%1&apos; 旁边没有另一轴</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing</source>
        <translation>缺少 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither true nor false</source>
        <translation>&apos;%1&apos; 既不是 true 也不是 false</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no delay</source>
        <translation>&apos;%1&apos; 不是有效延迟</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no name for a file</source>
        <translation>&apos;%1&apos; 不能作文件名</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none</source>
        <translation>&apos;%1&apos; 不是</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not KEY=VALUE</source>
        <translation>&apos;%1&apos; 不是 KEY=VALUE 形式</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a choice</source>
        <translation>&apos;%1&apos; 不在可选项中</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>&apos;%1&apos; 不是数字</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a time and a speed</source>
        <translation>&apos;%1&apos; 不是时间与转速</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known</source>
        <translation>&apos;%1&apos; 未知</translation>
    </message>
    <message>
        <source>&apos;%1&apos; promises more numbers than the file holds</source>
        <translation>&apos;%1&apos; 声明的数多于文件所含</translation>
    </message>
    <message>
        <source>&apos;%1channels&apos; is %2</source>
        <translation>&apos;%1channels&apos; 为 %2</translation>
    </message>
    <message>
        <source>&apos;adaptive_feed&apos; needs &apos;hal_component_port&apos;</source>
        <translation>&apos;adaptive_feed&apos; 需要 &apos;hal_component_port&apos;</translation>
    </message>
    <message>
        <source>&apos;full_stroke_um&apos; is less</source>
        <translation>&apos;full_stroke_um&apos; 更小</translation>
    </message>
    <message>
        <source>&apos;input_x&apos; and &apos;input_y&apos;</source>
        <translation>&apos;input_x&apos; 和 &apos;input_y&apos;</translation>
    </message>
    <message>
        <source>&apos;map&apos; is missing</source>
        <translation>缺少 &apos;map&apos;</translation>
    </message>
    <message>
        <source>&apos;output_x&apos; and &apos;output_y&apos;</source>
        <translation>&apos;output_x&apos; 和 &apos;output_y&apos;</translation>
    </message>
    <message>
        <source>&apos;rate_hz&apos; = %1 is not among its rates</source>
        <translation>&apos;rate_hz&apos; = %1 不在其采样率之中</translation>
    </message>
    <message>
        <source>&apos;rms&apos; must be above 0 and at most 0.3 of the stroke</source>
        <translation>&apos;rms&apos; 必须大于 0 且不超过行程的 0.3</translation>
    </message>
    <message>
        <source>&apos;source.id&apos; is missing</source>
        <translation>缺少 &apos;source.id&apos;</translation>
    </message>
    <message>
        <source>&apos;stroke_um&apos; is more than the output can drive</source>
        <translation>&apos;stroke_um&apos; 超过输出能力</translation>
    </message>
    <message>
        <source>/24 or a larger number</source>
        <translation>/24 或更大的数</translation>
    </message>
    <message>
        <source>0 to 1000000 rpm</source>
        <translation>0 至 1000000 转/分</translation>
    </message>
    <message>
        <source>1 to 32 sensors are needed</source>
        <translation>需要 1 至 32 个传感器</translation>
    </message>
    <message>
        <source>1 to 64 channels and a rate above zero were expected</source>
        <translation>应为 1 至 64 个通道且采样率大于零</translation>
    </message>
    <message>
        <source>1_id, 1_channels, 1_delay_ms and 1_ with the device&apos;s own settings, then 2_</source>
        <translation>1_id、1_channels、1_delay_ms 及带设备自身设置的 1_，然后是 2_</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>连接中断</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>连接被拒绝；对端是否在运行？</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>连接超时；请检查地址与线缆</translation>
    </message>
    <message>
        <source>DEC and IBM formats are not read</source>
        <translation>不支持 DEC 和 IBM 格式</translation>
    </message>
    <message>
        <source>Delta_X holds &apos;%1&apos;</source>
        <translation>Delta_X 的值为 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>被占用：另一程序正在使用</translation>
    </message>
    <message>
        <source>FLAC holds at most 8 channels</source>
        <translation>FLAC 最多 8 个通道</translation>
    </message>
    <message>
        <source>Format not recognised.</source>
        <translation>无法识别格式。</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>输入/输出错误；请检查线缆与设备</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>是文件夹</translation>
    </message>
    <message>
        <source>Modbus is not part of this build</source>
        <translation>此版本不含 Modbus</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>无法到达主机；请检查网络与地址</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘已满；请腾出空间</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>没有此设备；是否已连接？</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>没有此设备或地址；是否已连接？</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>没有此文件或文件夹</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>不是文件夹</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>没有权限；请检查所有者与权限</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>文件系统只读</translation>
    </message>
    <message>
        <source>SI units per device unit</source>
        <translation>每设备单位的 SI 值</translation>
    </message>
    <message>
        <source>Stillcut session</source>
        <translation>Stillcut 会话</translation>
    </message>
    <message>
        <source>Supported file format but file is malformed.</source>
        <translation>格式受支持，但文件有误。</translation>
    </message>
    <message>
        <source>Supported file format but unsupported encoding.</source>
        <translation>格式受支持，但编码不受支持。</translation>
    </message>
    <message>
        <source>System error.</source>
        <translation>系统错误。</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>打开的文件过多</translation>
    </message>
    <message>
        <source>[cut] speed_rpm or feed_mm_min is missing</source>
        <translation>缺少 [cut] speed_rpm 或 feed_mm_min</translation>
    </message>
    <message>
        <source>a block has %1 channels</source>
        <translation>一个数据块有 %1 个通道</translation>
    </message>
    <message>
        <source>a block needs at least one frame</source>
        <translation>一个数据块至少需要一帧</translation>
    </message>
    <message>
        <source>a coil or discrete input is one bit</source>
        <translation>线圈或离散输入只有一位</translation>
    </message>
    <message>
        <source>a cutting speed cannot be limited without the tool&apos;s diameter</source>
        <translation>没有刀具直径就无法限制切削速度</translation>
    </message>
    <message>
        <source>a damaged file</source>
        <translation>文件已损坏</translation>
    </message>
    <message>
        <source>a damaged or truncated file</source>
        <translation>文件损坏或被截断</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>一个设备</translation>
    </message>
    <message>
        <source>a finite number was expected</source>
        <translation>应为有限数</translation>
    </message>
    <message>
        <source>a gap of %1 s</source>
        <translation>%1 s 的间隙</translation>
    </message>
    <message>
        <source>a history of features; detectors need the samples themselves</source>
        <translation>只是特征历史；检测器需要采样本身</translation>
    </message>
    <message>
        <source>a path cannot be taken over while the table moves</source>
        <translation>工作台运动时不能采用路径</translation>
    </message>
    <message>
        <source>a quarter of a revolution must fit into 512 samples</source>
        <translation>四分之一转必须在 512 个采样之内</translation>
    </message>
    <message>
        <source>a range is two numbers, lowest and highest</source>
        <translation>范围是两个数：最小与最大</translation>
    </message>
    <message>
        <source>a recording of this name is still being written, or was cut off; take another name</source>
        <translation>同名记录仍在写入，或曾被中断；请换一个名称</translation>
    </message>
    <message>
        <source>a run needs a device</source>
        <translation>运行需要设备</translation>
    </message>
    <message>
        <source>a scenario is needed</source>
        <translation>需要一个场景</translation>
    </message>
    <message>
        <source>a second segment of the measurement begins</source>
        <translation>测量的第二段开始</translation>
    </message>
    <message>
        <source>a sensor needs a name</source>
        <translation>传感器需要名称</translation>
    </message>
    <message>
        <source>a session, or a recording of any kind that is imported</source>
        <translation>会话，或任何可导入的记录</translation>
    </message>
    <message>
        <source>a simulated or recorded cut may not drive a real machine</source>
        <translation>模拟或记录的切削不得驱动真实机床</translation>
    </message>
    <message>
        <source>a table is missing or has another layout</source>
        <translation>缺少表格或结构不同</translation>
    </message>
    <message>
        <source>a time step above zero was expected</source>
        <translation>时间步长应大于零</translation>
    </message>
    <message>
        <source>a truncated file, or its header is wrong</source>
        <translation>文件被截断，或文件头错误</translation>
    </message>
    <message>
        <source>a truncated or damaged file</source>
        <translation>文件被截断或损坏</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>有值超出范围</translation>
    </message>
    <message>
        <source>a value must belong to one voltage</source>
        <translation>一个值只能对应一个电压</translation>
    </message>
    <message>
        <source>above 0 and up to 1000 mm</source>
        <translation>大于 0 且不超过 1000 mm</translation>
    </message>
    <message>
        <source>above 0 and up to 1e6 rpm</source>
        <translation>大于 0 且不超过 1e6 rpm</translation>
    </message>
    <message>
        <source>active &apos;alsa&apos;</source>
        <translation>主动 &apos;alsa&apos;</translation>
    </message>
    <message>
        <source>actuator</source>
        <translation>执行器</translation>
    </message>
    <message>
        <source>all are time, indicators or empty</source>
        <translation>全是时间、指标或空白</translation>
    </message>
    <message>
        <source>allowed: %1 and above</source>
        <translation>允许：%1 及以上</translation>
    </message>
    <message>
        <source>allowed: %1 to %2</source>
        <translation>允许：%1 至 %2</translation>
    </message>
    <message>
        <source>allowed: up to %1</source>
        <translation>允许：不超过 %1</translation>
    </message>
    <message>
        <source>an echo is two numbers, delay in ms and gain</source>
        <translation>回声是两个数：延迟（ms）和增益</translation>
    </message>
    <message>
        <source>an echo&apos;s delay must lie between 0 and 1 s</source>
        <translation>回声延迟必须在 0 到 1 s 之间</translation>
    </message>
    <message>
        <source>analog outputs are not part of this build</source>
        <translation>此版本不含模拟输出</translation>
    </message>
    <message>
        <source>angles above zero, 360 degrees together</source>
        <translation>角度大于零，总和 360 度</translation>
    </message>
    <message>
        <source>announces %1 bytes, but its points take %2</source>
        <translation>声明 %1 字节，但其点占 %2 字节</translation>
    </message>
    <message>
        <source>announces %1 points, more than the file holds</source>
        <translation>声明 %1 个点，多于文件所含</translation>
    </message>
    <message>
        <source>as 192.168.1.0/24</source>
        <translation>如 192.168.1.0/24</translation>
    </message>
    <message>
        <source>as many as the device sends, 1 to %1</source>
        <translation>与设备发送的一样多，1 至 %1</translation>
    </message>
    <message>
        <source>at least %1 samples</source>
        <translation>至少 %1 个采样</translation>
    </message>
    <message>
        <source>at least one mode is needed</source>
        <translation>至少需要一个模态</translation>
    </message>
    <message>
        <source>at most %1 frequencies above 0, for example 339, 1024</source>
        <translation>最多 %1 个大于 0 的频率，例如 339, 1024</translation>
    </message>
    <message>
        <source>at most %1 modes can be simulated</source>
        <translation>最多可模拟 %1 个模态</translation>
    </message>
    <message>
        <source>at most 31, 63 and 511 bytes</source>
        <translation>最多 31、63 和 511 字节</translation>
    </message>
    <message>
        <source>at most 8</source>
        <translation>最多 8</translation>
    </message>
    <message>
        <source>at point %1</source>
        <translation>在第 %1 点</translation>
    </message>
    <message>
        <source>axis must be x or y</source>
        <translation>axis 必须为 x 或 y</translation>
    </message>
    <message>
        <source>binary frames begin with 1 to 8 bytes in hexadecimal, for example AA55</source>
        <translation>二进制帧以 1 至 8 个十六进制字节开头，例如 AA55</translation>
    </message>
    <message>
        <source>block frames must lie between 1 and 65536</source>
        <translation>块帧数必须在 1 到 65536 之间</translation>
    </message>
    <message>
        <source>blocks of %1 frames are too long</source>
        <translation>%1 帧的数据块过长</translation>
    </message>
    <message>
        <source>blocks were lost since the record was made</source>
        <translation>自记录以来有数据块丢失</translation>
    </message>
    <message>
        <source>blocks were lost, and input and output of this device do not start together</source>
        <translation>数据块丢失，且此设备的输入与输出不同时启动</translation>
    </message>
    <message>
        <source>byte order, format, lines, bytes</source>
        <translation>字节序、格式、行数、字节数</translation>
    </message>
    <message>
        <source>cannot be decided again</source>
        <translation>无法重新判定</translation>
    </message>
    <message>
        <source>cannot be drawn so</source>
        <translation>无法这样绘制</translation>
    </message>
    <message>
        <source>cannot be marked: the journal beside it belongs to another recording, or is in use</source>
        <translation>无法标记：旁边的日志属于另一记录，或正在使用</translation>
    </message>
    <message>
        <source>cannot be opened for %1</source>
        <translation>无法为 %1 打开</translation>
    </message>
    <message>
        <source>cannot be recorded</source>
        <translation>无法记录</translation>
    </message>
    <message>
        <source>cannot identify while the table moves</source>
        <translation>工作台运动时不能辨识</translation>
    </message>
    <message>
        <source>cannot stream at a rate</source>
        <translation>不能以固定采样率传输</translation>
    </message>
    <message>
        <source>channels, block length or rate</source>
        <translation>通道、块长或采样率</translation>
    </message>
    <message>
        <source>channels, rate and block length must be known before</source>
        <translation>必须先知道通道、采样率和块长</translation>
    </message>
    <message>
        <source>check the machine&apos;s profile</source>
        <translation>请检查机床配置</translation>
    </message>
    <message>
        <source>choices: %1</source>
        <translation>可选：%1</translation>
    </message>
    <message>
        <source>choices: acceleration, velocity, displacement, sound, force, current, speed</source>
        <translation>可选：acceleration、velocity、displacement、sound、force、current、speed</translation>
    </message>
    <message>
        <source>choices: iepe, ac, dc</source>
        <translation>可选：iepe、ac、dc</translation>
    </message>
    <message>
        <source>choose some with --channel N[,N]</source>
        <translation>用 --channel N[,N] 选择</translation>
    </message>
    <message>
        <source>coil or holding</source>
        <translation>coil 或 holding</translation>
    </message>
    <message>
        <source>column %1 holds %2</source>
        <translation>第 %1 列的值为 %2</translation>
    </message>
    <message>
        <source>configure with STILLCUT_DESKTOP=ON</source>
        <translation>请用 STILLCUT_DESKTOP=ON 构建</translation>
    </message>
    <message>
        <source>convert to CSV instead, or a span without it</source>
        <translation>请改为转换成 CSV，或选不含它的时段</translation>
    </message>
    <message>
        <source>could not be repaired</source>
        <translation>无法修复</translation>
    </message>
    <message>
        <source>cutting coefficients must be finite</source>
        <translation>切削力系数必须为有限数</translation>
    </message>
    <message>
        <source>damping ratio must lie between 0 and 1</source>
        <translation>阻尼比必须在 0 到 1 之间</translation>
    </message>
    <message>
        <source>detector</source>
        <translation>检测器</translation>
    </message>
    <message>
        <source>diameter must be above zero</source>
        <translation>直径必须大于零</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;?</source>
        <translation>是否指 &apos;%1&apos;？</translation>
    </message>
    <message>
        <source>direction must not be zero</source>
        <translation>方向不得为零</translation>
    </message>
    <message>
        <source>does not end after its %1 points</source>
        <translation>在 %1 个点之后没有结束</translation>
    </message>
    <message>
        <source>does not go once around</source>
        <translation>未构成一整圈</translation>
    </message>
    <message>
        <source>does not hold 100 %</source>
        <translation>不含 100 %</translation>
    </message>
    <message>
        <source>does not take the trigger &apos;%1&apos;</source>
        <translation>不接受触发器 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>does not tell its range</source>
        <translation>未给出量程</translation>
    </message>
    <message>
        <source>does the calibrator run, on this channel, and is the machine quiet?</source>
        <translation>校准器是否在此通道上运行，机床是否安静？</translation>
    </message>
    <message>
        <source>duration must lie between 0 and 3600 s</source>
        <translation>时长必须在 0 到 3600 s 之间</translation>
    </message>
    <message>
        <source>each override has an output of its own</source>
        <translation>每个倍率都有各自的输出</translation>
    </message>
    <message>
        <source>ended before the record was whole</source>
        <translation>记录完整之前就结束了</translation>
    </message>
    <message>
        <source>ends after %1 of %2 frames</source>
        <translation>在 %2 帧中的第 %1 帧后结束</translation>
    </message>
    <message>
        <source>ends after %1 of %2 points</source>
        <translation>在 %2 点中的第 %1 点后结束</translation>
    </message>
    <message>
        <source>ends before it begins</source>
        <translation>结束早于开始</translation>
    </message>
    <message>
        <source>ends early</source>
        <translation>提前结束</translation>
    </message>
    <message>
        <source>every value must be above zero</source>
        <translation>每个值都必须大于零</translation>
    </message>
    <message>
        <source>every value would be the offset</source>
        <translation>每个值都会是偏移量</translation>
    </message>
    <message>
        <source>exponent must lie in (0, 1]</source>
        <translation>指数必须在 (0, 1] 之内</translation>
    </message>
    <message>
        <source>feed lag must lie between 0 and 10 s</source>
        <translation>进给滞后必须在 0 到 10 s 之间</translation>
    </message>
    <message>
        <source>feed per tooth must lie between 0 and 10 mm</source>
        <translation>每齿进给必须在 0 到 10 mm 之间</translation>
    </message>
    <message>
        <source>feed per tooth must not be negative</source>
        <translation>每齿进给不得为负</translation>
    </message>
    <message>
        <source>fits no path</source>
        <translation>与任何路径不符</translation>
    </message>
    <message>
        <source>for example energy-ratio.chatter=0.2</source>
        <translation>例如 energy-ratio.chatter=0.2</translation>
    </message>
    <message>
        <source>force feedback needs one per axis</source>
        <translation>力反馈每轴需要一个</translation>
    </message>
    <message>
        <source>frame %1 of channel %2 is not a finite number</source>
        <translation>通道 %2 的第 %1 帧不是有限数</translation>
    </message>
    <message>
        <source>frequency must be above zero</source>
        <translation>频率必须大于零</translation>
    </message>
    <message>
        <source>from must lie before to, with 1 to 65536 columns</source>
        <translation>from 必须在 to 之前，列数为 1 至 65536</translation>
    </message>
    <message>
        <source>gain must not be zero</source>
        <translation>增益不得为零</translation>
    </message>
    <message>
        <source>give --rate HZ to read the rows as evenly spaced</source>
        <translation>用 --rate HZ 按等间隔读取各行</translation>
    </message>
    <message>
        <source>give --rate HZ to read the samples as evenly spaced</source>
        <translation>用 --rate HZ 按等间隔读取采样</translation>
    </message>
    <message>
        <source>give it with --rate HZ</source>
        <translation>请用 --rate HZ 给出</translation>
    </message>
    <message>
        <source>give the diameter or set it to auto</source>
        <translation>请给出直径或设为 auto</translation>
    </message>
    <message>
        <source>half a second at most</source>
        <translation>最多半秒</translation>
    </message>
    <message>
        <source>has %1 channels at %2 Hz</source>
        <translation>有 %1 个通道，%2 Hz</translation>
    </message>
    <message>
        <source>has %1 columns where %2 were expected</source>
        <translation>有 %1 列，应为 %2 列</translation>
    </message>
    <message>
        <source>has a row of %1 numbers</source>
        <translation>有一行含 %1 个数</translation>
    </message>
    <message>
        <source>has different periods for input and output</source>
        <translation>输入与输出的周期不同</translation>
    </message>
    <message>
        <source>has fewer than two points</source>
        <translation>少于两个点</translation>
    </message>
    <message>
        <source>has more numbers than its %1 points</source>
        <translation>数多于其 %1 个点</translation>
    </message>
    <message>
        <source>has more than 256 columns</source>
        <translation>超过 256 列</translation>
    </message>
    <message>
        <source>has more than 64 channels</source>
        <translation>超过 64 个通道</translation>
    </message>
    <message>
        <source>has no %1 Hz (%2)</source>
        <translation>没有 %1 Hz（%2）</translation>
    </message>
    <message>
        <source>has no %1 channels (%2)</source>
        <translation>没有 %1 个通道（%2）</translation>
    </message>
    <message>
        <source>has no %1 channels (&apos;inputs&apos;)</source>
        <translation>没有 %1 个通道（&apos;inputs&apos;）</translation>
    </message>
    <message>
        <source>has no active work-holder</source>
        <translation>没有主动工件夹具</translation>
    </message>
    <message>
        <source>has no channel %1</source>
        <translation>没有通道 %1</translation>
    </message>
    <message>
        <source>has no column &apos;%1&apos;</source>
        <translation>没有列 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>has no end</source>
        <translation>没有结尾</translation>
    </message>
    <message>
        <source>has no input %1 (&apos;inputs&apos;)</source>
        <translation>没有输入 %1（&apos;inputs&apos;）</translation>
    </message>
    <message>
        <source>has no marker %1</source>
        <translation>没有标记 %1</translation>
    </message>
    <message>
        <source>has no marker &apos;%1&apos;</source>
        <translation>没有标记 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>has no range %1 (&apos;range&apos;)</source>
        <translation>没有量程 %1（&apos;range&apos;）</translation>
    </message>
    <message>
        <source>has no samples of %1 bits (&apos;bits&apos;)</source>
        <translation>没有 %1 位采样（&apos;bits&apos;）</translation>
    </message>
    <message>
        <source>has no samples of 32 bits (%1)</source>
        <translation>没有 32 位采样（%1）</translation>
    </message>
    <message>
        <source>has the channel of &apos;speed&apos;</source>
        <translation>与 &apos;speed&apos; 使用同一通道</translation>
    </message>
    <message>
        <source>header inconsistent</source>
        <translation>文件头不一致</translation>
    </message>
    <message>
        <source>helix must lie within 80 degrees</source>
        <translation>螺旋角必须在 80 度以内</translation>
    </message>
    <message>
        <source>helix slices must lie between 1 and 200</source>
        <translation>螺旋切片数必须在 1 到 200 之间</translation>
    </message>
    <message>
        <source>hold sensor and calibrator still</source>
        <translation>请保持传感器与校准器不动</translation>
    </message>
    <message>
        <source>holds %1 data sets in several places</source>
        <translation>多处共有 %1 个数据集</translation>
    </message>
    <message>
        <source>holds a row that is not all finite numbers</source>
        <translation>有一行不全是有限数</translation>
    </message>
    <message>
        <source>holds a value that is not finite</source>
        <translation>含有非有限值</translation>
    </message>
    <message>
        <source>holds bytes that are no text</source>
        <translation>含有非文本字节</translation>
    </message>
    <message>
        <source>holds fewer bytes than it announces</source>
        <translation>字节少于声明</translation>
    </message>
    <message>
        <source>holds more than 4096 channels</source>
        <translation>超过 4096 个通道</translation>
    </message>
    <message>
        <source>holds more than 4096 objects</source>
        <translation>超过 4096 个对象</translation>
    </message>
    <message>
        <source>holds more than 4096 variables</source>
        <translation>超过 4096 个变量</translation>
    </message>
    <message>
        <source>holds no array of samples</source>
        <translation>没有采样数组</translation>
    </message>
    <message>
        <source>holds no data set of numbers</source>
        <translation>没有数值数据集</translation>
    </message>
    <message>
        <source>holds no dataset 58</source>
        <translation>没有 58 数据集</translation>
    </message>
    <message>
        <source>holds no samples</source>
        <translation>没有采样</translation>
    </message>
    <message>
        <source>holds no speeds</source>
        <translation>没有转速</translation>
    </message>
    <message>
        <source>holds no time recording</source>
        <translation>没有时域记录</translation>
    </message>
    <message>
        <source>holds no truth</source>
        <translation>没有真值</translation>
    </message>
    <message>
        <source>holds no variable that can be read</source>
        <translation>没有可读变量</translation>
    </message>
    <message>
        <source>holds something that is not a finite number</source>
        <translation>含有非有限数的内容</translation>
    </message>
    <message>
        <source>holds something that is not a text</source>
        <translation>含有非文本的内容</translation>
    </message>
    <message>
        <source>holds times that are not finite</source>
        <translation>含有非有限的时间</translation>
    </message>
    <message>
        <source>identification</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>identify first</source>
        <translation>请先辨识</translation>
    </message>
    <message>
        <source>identify it again</source>
        <translation>请重新辨识</translation>
    </message>
    <message>
        <source>identify it first</source>
        <translation>请先辨识</translation>
    </message>
    <message>
        <source>input %1 has %2 bits in %3</source>
        <translation>输入 %1 在 %3 中有 %2 位</translation>
    </message>
    <message>
        <source>input/output error</source>
        <translation>输入/输出错误</translation>
    </message>
    <message>
        <source>install %1 and build again</source>
        <translation>请安装 %1 并重新构建</translation>
    </message>
    <message>
        <source>install libcomedi-dev and build again</source>
        <translation>请安装 libcomedi-dev 并重新构建</translation>
    </message>
    <message>
        <source>is 0</source>
        <translation>为 0</translation>
    </message>
    <message>
        <source>is 2</source>
        <translation>为 2</translation>
    </message>
    <message>
        <source>is a folder, not a recording</source>
        <translation>是文件夹，不是记录</translation>
    </message>
    <message>
        <source>is a session of version %1</source>
        <translation>是版本 %1 的会话</translation>
    </message>
    <message>
        <source>is an HDF5 file, but not a Stillcut session</source>
        <translation>是 HDF5 文件，但不是 Stillcut 会话</translation>
    </message>
    <message>
        <source>is being written already</source>
        <translation>正在被写入</translation>
    </message>
    <message>
        <source>is cut short: its end is missing</source>
        <translation>被截断：缺少结尾</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>为空</translation>
    </message>
    <message>
        <source>is given beside &apos;device&apos;</source>
        <translation>与 &apos;device&apos; 同时给出</translation>
    </message>
    <message>
        <source>is given beside sensitivity_mv</source>
        <translation>与 sensitivity_mv 同时给出</translation>
    </message>
    <message>
        <source>is halrmt running there?</source>
        <translation>那里是否运行着 halrmt？</translation>
    </message>
    <message>
        <source>is it connected?</source>
        <translation>是否已连接？</translation>
    </message>
    <message>
        <source>is larger than 16 MB: no file of settings</source>
        <translation>大于 16 MB：不是设置文件</translation>
    </message>
    <message>
        <source>is later than on-line identification looks, %1 samples</source>
        <translation>晚于在线辨识的范围，%1 个采样</translation>
    </message>
    <message>
        <source>is linuxcncrsh running there?</source>
        <translation>那里是否运行着 linuxcncrsh？</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>is missing or no object in JSON</source>
        <translation>缺失或不是 JSON 对象</translation>
    </message>
    <message>
        <source>is missing, and so is &apos;feed&apos;</source>
        <translation>缺失，&apos;feed&apos; 也缺失</translation>
    </message>
    <message>
        <source>is more than 256 addresses</source>
        <translation>超过 256 个地址</translation>
    </message>
    <message>
        <source>is neither true nor false</source>
        <translation>既不是 true 也不是 false</translation>
    </message>
    <message>
        <source>is no MATLAB file of version 5 or 7</source>
        <translation>不是 5 或 7 版的 MATLAB 文件</translation>
    </message>
    <message>
        <source>is no MATLAB file of version 5 to 7.3</source>
        <translation>不是 5 至 7.3 版的 MATLAB 文件</translation>
    </message>
    <message>
        <source>is no gap of the recording beside it</source>
        <translation>不是旁边记录中的间隙</translation>
    </message>
    <message>
        <source>is no lobe case</source>
        <translation>不是稳定性叶瓣图案例</translation>
    </message>
    <message>
        <source>is no session</source>
        <translation>不是会话</translation>
    </message>
    <message>
        <source>is no session file</source>
        <translation>不是会话文件</translation>
    </message>
    <message>
        <source>is no sound file that can be read</source>
        <translation>不是可读的声音文件</translation>
    </message>
    <message>
        <source>is no subnet</source>
        <translation>不是子网</translation>
    </message>
    <message>
        <source>is not a choice: &apos;%1&apos;</source>
        <translation>不在可选项中：&apos;%1&apos;</translation>
    </message>
    <message>
        <source>is not a finite number</source>
        <translation>不是有限数</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>不是数字</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>不是普通文件</translation>
    </message>
    <message>
        <source>is not a single value</source>
        <translation>不是单个值</translation>
    </message>
    <message>
        <source>is not a table</source>
        <translation>不是表</translation>
    </message>
    <message>
        <source>is not a text</source>
        <translation>不是文本</translation>
    </message>
    <message>
        <source>is not a whole number</source>
        <translation>不是整数</translation>
    </message>
    <message>
        <source>is not an array of numbers</source>
        <translation>不是数字数组</translation>
    </message>
    <message>
        <source>is not an array of rows</source>
        <translation>不是行数组</translation>
    </message>
    <message>
        <source>is not an array of tables</source>
        <translation>不是表数组</translation>
    </message>
    <message>
        <source>is not an array of texts</source>
        <translation>不是文本数组</translation>
    </message>
    <message>
        <source>is not at %1</source>
        <translation>不在 %1</translation>
    </message>
    <message>
        <source>is not repaired: the journal beside it does not fit it</source>
        <translation>未修复：旁边的日志与其不符</translation>
    </message>
    <message>
        <source>is not replaced</source>
        <translation>不会被替换</translation>
    </message>
    <message>
        <source>is out of range: %1</source>
        <translation>超出范围：%1</translation>
    </message>
    <message>
        <source>is spindle 0 configured?</source>
        <translation>是否配置了主轴 0？</translation>
    </message>
    <message>
        <source>is still being recorded</source>
        <translation>仍在记录中</translation>
    </message>
    <message>
        <source>is stillcut-hal loaded by the machine&apos;s HAL file, and LinuxCNC started by this user?</source>
        <translation>机床的 HAL 文件是否加载了 stillcut-hal，LinuxCNC 是否由当前用户启动？</translation>
    </message>
    <message>
        <source>is stillcut.hal wired as it came?</source>
        <translation>stillcut.hal 是否按原样连接？</translation>
    </message>
    <message>
        <source>is stored in pieces of more than 64 MB</source>
        <translation>以超过 64 MB 的块存储</translation>
    </message>
    <message>
        <source>is the machine on, and the address right?</source>
        <translation>机床是否开机，地址是否正确？</translation>
    </message>
    <message>
        <source>is this a recording?</source>
        <translation>这是记录吗？</translation>
    </message>
    <message>
        <source>is this the controller&apos;s port, and the baud rate right?</source>
        <translation>这是控制器的端口吗，波特率是否正确？</translation>
    </message>
    <message>
        <source>is true without [write.heartbeat]</source>
        <translation>为 true 但没有 [write.heartbeat]</translation>
    </message>
    <message>
        <source>is unknown: &apos;%1&apos;</source>
        <translation>未知：&apos;%1&apos;</translation>
    </message>
    <message>
        <source>is zero</source>
        <translation>为零</translation>
    </message>
    <message>
        <source>it begins before the previous one ends</source>
        <translation>它在前一段结束之前开始</translation>
    </message>
    <message>
        <source>it ends before it begins</source>
        <translation>它在开始之前结束</translation>
    </message>
    <message>
        <source>it goes through stillcut-hal</source>
        <translation>它通过 stillcut-hal</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>它有 %1</translation>
    </message>
    <message>
        <source>it has %1, counted from 0</source>
        <translation>它有 %1，从 0 数起</translation>
    </message>
    <message>
        <source>it has 0 to %1</source>
        <translation>它有 0 至 %1</translation>
    </message>
    <message>
        <source>it has changed since it was opened</source>
        <translation>打开后已被更改</translation>
    </message>
    <message>
        <source>it has no markers</source>
        <translation>它没有标记</translation>
    </message>
    <message>
        <source>it has, from 0: %1</source>
        <translation>它有，从 0 起：%1</translation>
    </message>
    <message>
        <source>it is a recorded session; take another name</source>
        <translation>这是已记录的会话；请换一个名称</translation>
    </message>
    <message>
        <source>it may be a recording that is damaged; take another name</source>
        <translation>可能是已损坏的记录；请换一个名称</translation>
    </message>
    <message>
        <source>it must be below %1</source>
        <translation>必须小于 %1</translation>
    </message>
    <message>
        <source>it names the file with outputs and calibration tables</source>
        <translation>它指定输出与校准表的文件</translation>
    </message>
    <message>
        <source>it names the file with the machine&apos;s registers</source>
        <translation>它指定机床寄存器的文件</translation>
    </message>
    <message>
        <source>it reads up to version %1</source>
        <translation>它最多读取到版本 %1</translation>
    </message>
    <message>
        <source>it samples at %1</source>
        <translation>它以 %1 采样</translation>
    </message>
    <message>
        <source>it says teeth and speed</source>
        <translation>它给出齿数与转速</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>已被停止</translation>
    </message>
    <message>
        <source>it would run out between two commands</source>
        <translation>它会在两次指令之间到期</translation>
    </message>
    <message>
        <source>its 58b line is incomplete</source>
        <translation>其 58b 行不完整</translation>
    </message>
    <message>
        <source>its abscissa start and step are missing</source>
        <translation>缺少横坐标起点与步长</translation>
    </message>
    <message>
        <source>its abscissa step is not positive</source>
        <translation>横坐标步长不是正数</translation>
    </message>
    <message>
        <source>its byte count is not a size</source>
        <translation>其字节数不是有效大小</translation>
    </message>
    <message>
        <source>its byte order is neither 1 (little) nor 2 (big endian)</source>
        <translation>其字节序既不是 1（小端）也不是 2（大端）</translation>
    </message>
    <message>
        <source>its ends must be finite</source>
        <translation>其两端必须为有限数</translation>
    </message>
    <message>
        <source>its header ends early</source>
        <translation>其文件头提前结束</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>其文件头已损坏</translation>
    </message>
    <message>
        <source>its header is missing</source>
        <translation>缺少文件头</translation>
    </message>
    <message>
        <source>its header is not 11 lines long</source>
        <translation>其文件头不是 11 行</translation>
    </message>
    <message>
        <source>its header is wrong</source>
        <translation>其文件头错误</translation>
    </message>
    <message>
        <source>its layout is damaged</source>
        <translation>其结构已损坏</translation>
    </message>
    <message>
        <source>its level must be above zero</source>
        <translation>其电平必须大于零</translation>
    </message>
    <message>
        <source>its name, as stillcut-cli devices lists it</source>
        <translation>其名称，如 stillcut-cli devices 所列</translation>
    </message>
    <message>
        <source>its number of points is not a size</source>
        <translation>其点数不是有效大小</translation>
    </message>
    <message>
        <source>its numbers are not IEEE 754</source>
        <translation>其数值不是 IEEE 754</translation>
    </message>
    <message>
        <source>its numbers make no sense in the byte order its header gives</source>
        <translation>按文件头的字节序，其数值没有意义</translation>
    </message>
    <message>
        <source>its ordinate type is none of 2, 4, 5, 6</source>
        <translation>其纵坐标类型不是 2、4、5、6</translation>
    </message>
    <message>
        <source>its phase is off by 90 degrees or more, or the sensor measures nothing of the actuator there</source>
        <translation>其相位偏差达 90 度或更多，或传感器在该处听不到执行器</translation>
    </message>
    <message>
        <source>its samples are not evenly spaced in time</source>
        <translation>其采样时间间隔不均匀</translation>
    </message>
    <message>
        <source>its samples lie in another file</source>
        <translation>其采样在另一文件中</translation>
    </message>
    <message>
        <source>its samples lie in other data sets</source>
        <translation>其采样在其他数据集中</translation>
    </message>
    <message>
        <source>its size line (record 7) is unreadable</source>
        <translation>其大小行（记录 7）无法读取</translation>
    </message>
    <message>
        <source>its times cannot be read</source>
        <translation>其时间无法读取</translation>
    </message>
    <message>
        <source>knock along %1, hard, with the machine quiet</source>
        <translation>请在机床安静时沿 %1 用力敲击</translation>
    </message>
    <message>
        <source>knock straight along %1, close to the sensor</source>
        <translation>请在传感器附近沿 %1 正向敲击</translation>
    </message>
    <message>
        <source>known: %1</source>
        <translation>已知：%1</translation>
    </message>
    <message>
        <source>label, author or note is too long</source>
        <translation>名称、作者或备注过长</translation>
    </message>
    <message>
        <source>largest depth</source>
        <translation>最大切深</translation>
    </message>
    <message>
        <source>leave it out for the usual value</source>
        <translation>省略则用通常值</translation>
    </message>
    <message>
        <source>leaves no room for two words</source>
        <translation>放不下两个字</translation>
    </message>
    <message>
        <source>leaves what a machine can do</source>
        <translation>超出机床能力</translation>
    </message>
    <message>
        <source>linearise the force at the mean chip thickness first</source>
        <translation>请先在平均切屑厚度处将力线性化</translation>
    </message>
    <message>
        <source>link</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>link &apos;simulated&apos;</source>
        <translation>连接 &apos;simulated&apos;</translation>
    </message>
    <message>
        <source>little and big endian mixed up</source>
        <translation>大小端混淆</translation>
    </message>
    <message>
        <source>mV per g, Pa, N ... of the data sheet</source>
        <translation>数据表中的 mV/g、Pa、N……</translation>
    </message>
    <message>
        <source>more than a million speeds</source>
        <translation>超过一百万个转速</translation>
    </message>
    <message>
        <source>move %1 away</source>
        <translation>请移走 %1</translation>
    </message>
    <message>
        <source>move %1 away to clear the mark of the dead writer alone</source>
        <translation>移走 %1，即可只清除已终止写入者的标记</translation>
    </message>
    <message>
        <source>must be a number from %1 to %2</source>
        <translation>必须为 %1 至 %2 的数</translation>
    </message>
    <message>
        <source>must be a number other than zero</source>
        <translation>必须为非零数</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>必须为整数</translation>
    </message>
    <message>
        <source>must be above zero</source>
        <translation>必须大于零</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>必须为 true 或 false</translation>
    </message>
    <message>
        <source>must take half a second to a minute</source>
        <translation>须为半秒至一分钟</translation>
    </message>
    <message>
        <source>name one of them or their folder: %1</source>
        <translation>请指定其一或其文件夹：%1</translation>
    </message>
    <message>
        <source>name the one to read: FILE:/path</source>
        <translation>请指定要读的：FILE:/path</translation>
    </message>
    <message>
        <source>names %1 columns where the rows have %2</source>
        <translation>列名有 %1 个，而各行有 %2 列</translation>
    </message>
    <message>
        <source>names parted by commas were expected</source>
        <translation>应为以逗号分隔的名称</translation>
    </message>
    <message>
        <source>needs one angle per tooth</source>
        <translation>每齿需要一个角度</translation>
    </message>
    <message>
        <source>needs the numbers t_s and ratio_chatter_to_forced</source>
        <translation>需要数值 t_s 和 ratio_chatter_to_forced</translation>
    </message>
    <message>
        <source>neither &apos;host&apos; nor &apos;device&apos; is given</source>
        <translation>既没有 &apos;host&apos; 也没有 &apos;device&apos;</translation>
    </message>
    <message>
        <source>no GRBL status report</source>
        <translation>没有 GRBL 状态报告</translation>
    </message>
    <message>
        <source>no accelerometer along %1</source>
        <translation>沿 %1 没有加速度计</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>没有应答</translation>
    </message>
    <message>
        <source>no column is a channel</source>
        <translation>没有一列是通道</translation>
    </message>
    <message>
        <source>no connection</source>
        <translation>没有连接</translation>
    </message>
    <message>
        <source>no dataset 58 in it</source>
        <translation>其中没有 58 数据集</translation>
    </message>
    <message>
        <source>no force sensor along %1</source>
        <translation>沿 %1 没有力传感器</translation>
    </message>
    <message>
        <source>no model of the path from actuator to sensor</source>
        <translation>没有从执行器到传感器的路径模型</translation>
    </message>
    <message>
        <source>no rows of numbers found in its first %1 lines</source>
        <translation>前 %1 行中没有数字行</translation>
    </message>
    <message>
        <source>no spindle speed is given</source>
        <translation>未给出主轴转速</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>noise, or a sensor that is not on the table</source>
        <translation>噪声，或传感器不在工作台上</translation>
    </message>
    <message>
        <source>none of its samples is a number</source>
        <translation>没有一个采样是数</translation>
    </message>
    <message>
        <source>none was measured</source>
        <translation>没有听到</translation>
    </message>
    <message>
        <source>not a Stillcut session either</source>
        <translation>也不是 Stillcut 会话</translation>
    </message>
    <message>
        <source>not a readable file</source>
        <translation>不是可读文件</translation>
    </message>
    <message>
        <source>not a universal file of measured functions</source>
        <translation>不是测量函数的通用文件</translation>
    </message>
    <message>
        <source>there is no signal</source>
        <translation>什么也听不到</translation>
    </message>
    <message>
        <source>nothing was recorded</source>
        <translation>没有记录任何内容</translation>
    </message>
    <message>
        <source>nothing was written to the actuator</source>
        <translation>没有写入执行器</translation>
    </message>
    <message>
        <source>one input from 0 for each of the %1 [[channels]], for example 0,1</source>
        <translation>%1 个 [[channels]] 各一个从 0 起的输入，例如 0,1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>one of them is needed</source>
        <translation>需要其中之一</translation>
    </message>
    <message>
        <source>one of them says it all</source>
        <translation>其中一个就够了</translation>
    </message>
    <message>
        <source>one of them says where the machine is</source>
        <translation>其中之一说明机床在哪里</translation>
    </message>
    <message>
        <source>one row of numbers is no recording</source>
        <translation>一行数字不成记录</translation>
    </message>
    <message>
        <source>only %1 % of the signal is a tone near %2 Hz</source>
        <translation>听到的只有 %1 % 是 %2 Hz 附近的音</translation>
    </message>
    <message>
        <source>only Stillcut sessions say how they were made</source>
        <translation>只有 Stillcut 会话记载其来历</translation>
    </message>
    <message>
        <source>only sessions have markers</source>
        <translation>只有会话有标记</translation>
    </message>
    <message>
        <source>open it first</source>
        <translation>请先打开</translation>
    </message>
    <message>
        <source>output and reading differ in length</source>
        <translation>输出与读数长度不同</translation>
    </message>
    <message>
        <source>peaks reach three times it</source>
        <translation>峰值达其三倍</translation>
    </message>
    <message>
        <source>pitch angles must be above zero</source>
        <translation>齿距角必须大于零</translation>
    </message>
    <message>
        <source>pitch angles must sum to 360 degrees</source>
        <translation>齿距角之和必须为 360 度</translation>
    </message>
    <message>
        <source>pitch needs one angle per tooth</source>
        <translation>齿距需要每齿一个角度</translation>
    </message>
    <message>
        <source>place needs one weight per mode</source>
        <translation>place 需要每个模态一个权重</translation>
    </message>
    <message>
        <source>plughw: in front of it converts them</source>
        <translation>前面加 plughw: 可转换</translation>
    </message>
    <message>
        <source>point %1 is not a finite number</source>
        <translation>第 %1 点不是有限数</translation>
    </message>
    <message>
        <source>point %1 is not finite</source>
        <translation>第 %1 点不是有限数</translation>
    </message>
    <message>
        <source>profile version %1 is newer than this program</source>
        <translation>配置版本 %1 比本程序新</translation>
    </message>
    <message>
        <source>promises more samples than the file holds</source>
        <translation>声明的采样多于文件所含</translation>
    </message>
    <message>
        <source>put names that hold the delimiter in quotes</source>
        <translation>含分隔符的名称请加引号</translation>
    </message>
    <message>
        <source>quantity or scale is missing or senseless</source>
        <translation>测量量或系数缺失或无意义</translation>
    </message>
    <message>
        <source>radial immersion must lie in (0, 1]</source>
        <translation>径向切入比必须在 (0, 1] 之内</translation>
    </message>
    <message>
        <source>ramps must be above zero and at most ten seconds</source>
        <translation>斜坡必须大于零且不超过十秒</translation>
    </message>
    <message>
        <source>random force must lie between 0 and 1000 N/sqrt(Hz)</source>
        <translation>随机力必须在 0 到 1000 N/sqrt(Hz) 之间</translation>
    </message>
    <message>
        <source>rate must lie between 10 Hz and 1 MHz</source>
        <translation>采样率必须在 10 Hz 到 1 MHz 之间</translation>
    </message>
    <message>
        <source>recording failed while %1</source>
        <translation>记录失败，步骤：%1</translation>
    </message>
    <message>
        <source>recording stopped: the disk is nearly full</source>
        <translation>记录已停止：磁盘将满；请腾出空间后重新开始</translation>
    </message>
    <message>
        <source>recording stopped: the file was deleted or moved away</source>
        <translation>记录已停止：文件被删除或移走</translation>
    </message>
    <message>
        <source>remove the list where it belongs to another file</source>
        <translation>若此表属于另一文件，请删除</translation>
    </message>
    <message>
        <source>rms in %1</source>
        <translation>有效值，单位 %1</translation>
    </message>
    <message>
        <source>runout must be finite</source>
        <translation>跳动必须为有限数</translation>
    </message>
    <message>
        <source>runout needs one value per tooth</source>
        <translation>跳动需要每齿一个值</translation>
    </message>
    <message>
        <source>samples a second, from 100 to 1000000</source>
        <translation>每秒采样数，100 至 1000000</translation>
    </message>
    <message>
        <source>samples a second, one of the device&apos;s</source>
        <translation>每秒采样数，取设备的采样率之一</translation>
    </message>
    <message>
        <source>save each segment as a file of its own</source>
        <translation>请将每段另存为单独文件</translation>
    </message>
    <message>
        <source>say which one it should lie along</source>
        <translation>请说明应沿哪一轴</translation>
    </message>
    <message>
        <source>see gate.highest-feed</source>
        <translation>见 gate.highest-feed</translation>
    </message>
    <message>
        <source>see gate.highest-speed, gate.tool-highest-speed, gate.holder-highest-speed and gate.highest-cutting-speed</source>
        <translation>见 gate.highest-speed、gate.tool-highest-speed、gate.holder-highest-speed 和 gate.highest-cutting-speed</translation>
    </message>
    <message>
        <source>semi-discretization needs 1 to 2000 cells a tooth period</source>
        <translation>半离散法每齿周期需要 1 至 2000 个单元</translation>
    </message>
    <message>
        <source>serial ports are not part of this build</source>
        <translation>此版本不含串口</translation>
    </message>
    <message>
        <source>set [device] subdevice</source>
        <translation>请设置 [device] subdevice</translation>
    </message>
    <message>
        <source>set its gain lower</source>
        <translation>请降低其增益</translation>
    </message>
    <message>
        <source>set-up</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>simulated machine</source>
        <translation>模拟机床</translation>
    </message>
    <message>
        <source>simulated source</source>
        <translation>模拟信号源</translation>
    </message>
    <message>
        <source>source</source>
        <translation>信号源</translation>
    </message>
    <message>
        <source>source &apos;simulated&apos;</source>
        <translation>信号源 &apos;simulated&apos;</translation>
    </message>
    <message>
        <source>speed must lie between 1 and 200000 rpm</source>
        <translation>转速必须在 1 到 200000 转/分之间</translation>
    </message>
    <message>
        <source>speeds must be FROM:TO:STEP with 0 &lt; FROM &lt;= TO</source>
        <translation>转速须为 FROM:TO:STEP，且 0 &lt; FROM &lt;= TO</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>stability lobes need a force exponent of 1</source>
        <translation>稳定性叶瓣图要求力指数为 1</translation>
    </message>
    <message>
        <source>steps must be 8 to 5000</source>
        <translation>steps 必须为 8 至 5000</translation>
    </message>
    <message>
        <source>steps per revolution must lie between 0 (automatic) and 1000000</source>
        <translation>每转步数必须在 0（自动）到 1000000 之间</translation>
    </message>
    <message>
        <source>stiffness must be above zero</source>
        <translation>刚度必须大于零</translation>
    </message>
    <message>
        <source>stop it first</source>
        <translation>请先停止</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>strategy &apos;active&apos; needs a table [work_holder]</source>
        <translation>策略 &apos;active&apos; 需要 [work_holder] 表</translation>
    </message>
    <message>
        <source>subdevice %1 is no analog output</source>
        <translation>子设备 %1 不是模拟输出</translation>
    </message>
    <message>
        <source>such a machine tells nothing of its program</source>
        <translation>这类机床不报告其程序</translation>
    </message>
    <message>
        <source>such devices are not part of this build</source>
        <translation>此版本不含这类设备</translation>
    </message>
    <message>
        <source>switch &apos;active.auxiliary&apos; off, or take shorter blocks</source>
        <translation>请关闭 &apos;active.auxiliary&apos;，或用更短的块</translation>
    </message>
    <message>
        <source>t0_s and t1_s must be times, one after the other</source>
        <translation>t0_s 与 t1_s 必须是先后两个时间</translation>
    </message>
    <message>
        <source>take a larger step</source>
        <translation>请用更大的步长</translation>
    </message>
    <message>
        <source>task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>the HDF5 file cannot be opened</source>
        <translation>HDF5 文件无法打开</translation>
    </message>
    <message>
        <source>the [[channels]] are %1 in all, and %2 of them are taken</source>
        <translation>[[channels]] 共 %1 个，其中 %2 个已占用</translation>
    </message>
    <message>
        <source>the active table needs one per axis</source>
        <translation>主动工作台每轴需要一个</translation>
    </message>
    <message>
        <source>the amplitude limit must be above zero</source>
        <translation>幅值限制必须大于零</translation>
    </message>
    <message>
        <source>the block does not fit where it is read to</source>
        <translation>数据块放不下</translation>
    </message>
    <message>
        <source>the calibrator&apos;s level</source>
        <translation>校准器的电平</translation>
    </message>
    <message>
        <source>the chosen channel has no axis</source>
        <translation>所选通道没有轴</translation>
    </message>
    <message>
        <source>the data chunk is missing: a truncated file</source>
        <translation>缺少数据块：文件被截断</translation>
    </message>
    <message>
        <source>the delays must rise from 0 or more to at most 10 s</source>
        <translation>延迟必须从 0 或以上递增，不超过 10 s</translation>
    </message>
    <message>
        <source>the device does not run</source>
        <translation>设备未运行</translation>
    </message>
    <message>
        <source>the devices have %1: N_channels says how many are theirs</source>
        <translation>各设备有 %1：N_channels 说明各占多少</translation>
    </message>
    <message>
        <source>the fastest mode swings %1 times between two teeth</source>
        <translation>最快的模态在两齿之间振动 %1 次</translation>
    </message>
    <message>
        <source>the feed range must rise from 0 or more to at most 300 %</source>
        <translation>进给范围必须从 0 或以上递增，不超过 300 %</translation>
    </message>
    <message>
        <source>the file is cut off</source>
        <translation>文件被截断</translation>
    </message>
    <message>
        <source>the file is cut off or its header is wrong</source>
        <translation>文件被截断或文件头错误</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>文件已损坏</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>the folder cannot be written to</source>
        <translation>无法写入文件夹</translation>
    </message>
    <message>
        <source>the gear&apos;s table must hold [cut] speed_rpm, or there is nothing to go back to</source>
        <translation>该挡位的表必须含 [cut] speed_rpm，否则无处可回</translation>
    </message>
    <message>
        <source>the header is not &apos;t,rpm&apos;</source>
        <translation>表头不是 &apos;t,rpm&apos;</translation>
    </message>
    <message>
        <source>the host cannot be found</source>
        <translation>找不到主机</translation>
    </message>
    <message>
        <source>the leak must lie between 0.9 and 1</source>
        <translation>泄漏因子必须在 0.9 到 1 之间</translation>
    </message>
    <message>
        <source>the lease is shorter than two blocks</source>
        <translation>授权短于两个数据块</translation>
    </message>
    <message>
        <source>the lease must be above zero and at most one second</source>
        <translation>授权必须大于零且不超过一秒</translation>
    </message>
    <message>
        <source>the level moves by %1 %</source>
        <translation>电平波动 %1 %</translation>
    </message>
    <message>
        <source>the line is too long</source>
        <translation>该行过长</translation>
    </message>
    <message>
        <source>the longest was %1 of %2</source>
        <translation>最长为 %2 中的 %1</translation>
    </message>
    <message>
        <source>the lowest feed is not below the highest</source>
        <translation>最低进给不低于最高进给</translation>
    </message>
    <message>
        <source>the lowest speed is not below the highest</source>
        <translation>最低转速不低于最高转速</translation>
    </message>
    <message>
        <source>the machine&apos;s override cannot reach the allowed range</source>
        <translation>机床倍率无法达到允许范围</translation>
    </message>
    <message>
        <source>the machine&apos;s state is incomplete</source>
        <translation>机床状态不完整</translation>
    </message>
    <message>
        <source>the machine&apos;s watchdog was not seen to act</source>
        <translation>未见机床看门狗动作</translation>
    </message>
    <message>
        <source>the marker cannot be written</source>
        <translation>无法写入标记</translation>
    </message>
    <message>
        <source>the markers cannot be read</source>
        <translation>无法读取标记</translation>
    </message>
    <message>
        <source>the model along %1 is %2 minutes old</source>
        <translation>沿 %1 的模型已有 %2 分钟</translation>
    </message>
    <message>
        <source>the model along %1 has no phase margin on the lines to quieten, worst at %2 Hz</source>
        <translation>沿 %1 的模型在需抑制的谱线上不保证稳定，最差在 %2 Hz</translation>
    </message>
    <message>
        <source>the nearest is %1</source>
        <translation>最接近的是 %1</translation>
    </message>
    <message>
        <source>the number of channels changed</source>
        <translation>通道数已改变</translation>
    </message>
    <message>
        <source>the order of semi-discretization must be 0 or 1</source>
        <translation>半离散法的阶数必须为 0 或 1</translation>
    </message>
    <message>
        <source>the output does not take the programmed values</source>
        <translation>输出不接受编程值</translation>
    </message>
    <message>
        <source>the pace must be above zero</source>
        <translation>速度必须大于零</translation>
    </message>
    <message>
        <source>the pace must be zero (as fast as possible) or above, with a clock</source>
        <translation>速度必须为零（尽可能快）或更大，并有时钟</translation>
    </message>
    <message>
        <source>the path may be later than its model says; identify it again</source>
        <translation>路径可能比模型更滞后；请重新辨识</translation>
    </message>
    <message>
        <source>the path&apos;s model has more than %1 taps</source>
        <translation>路径模型超过 %1 个系数</translation>
    </message>
    <message>
        <source>the path&apos;s model holds a number that is not finite</source>
        <translation>路径模型含有非有限数</translation>
    </message>
    <message>
        <source>the path&apos;s model is delayed by more than %1 samples</source>
        <translation>路径模型延迟超过 %1 个采样</translation>
    </message>
    <message>
        <source>the path&apos;s model is unstable</source>
        <translation>路径模型不稳定</translation>
    </message>
    <message>
        <source>the path&apos;s model says that the actuator does nothing</source>
        <translation>路径模型表明执行器不起作用</translation>
    </message>
    <message>
        <source>the paths are being identified</source>
        <translation>正在辨识路径</translation>
    </message>
    <message>
        <source>the profile&apos;s has %1</source>
        <translation>配置中的有 %1</translation>
    </message>
    <message>
        <source>the programmed speed is outside the speed table</source>
        <translation>编程转速在转速表之外</translation>
    </message>
    <message>
        <source>the programmed value must be reachable</source>
        <translation>编程值必须可达</translation>
    </message>
    <message>
        <source>the range of the feed override is empty</source>
        <translation>进给倍率范围为空</translation>
    </message>
    <message>
        <source>the range of the speed override is empty</source>
        <translation>转速倍率范围为空</translation>
    </message>
    <message>
        <source>the reading does not follow the actuator</source>
        <translation>读数不跟随执行器</translation>
    </message>
    <message>
        <source>the registers do not answer</source>
        <translation>寄存器没有应答</translation>
    </message>
    <message>
        <source>the repaired file could not be written</source>
        <translation>修复后的文件无法写入</translation>
    </message>
    <message>
        <source>the sample rate must be above zero</source>
        <translation>采样率必须大于零</translation>
    </message>
    <message>
        <source>the samples are missing</source>
        <translation>缺少采样</translation>
    </message>
    <message>
        <source>the samples cannot be read</source>
        <translation>采样无法读取</translation>
    </message>
    <message>
        <source>the sampling rate is not known: it holds neither a rate nor times</source>
        <translation>采样率未知：既无采样率也无时间</translation>
    </message>
    <message>
        <source>the sampling rate is not known: there is no time column</source>
        <translation>采样率未知：没有时间列</translation>
    </message>
    <message>
        <source>the sampling rate is senseless</source>
        <translation>采样率无意义</translation>
    </message>
    <message>
        <source>the sensor read nothing</source>
        <translation>传感器没有读数</translation>
    </message>
    <message>
        <source>the session file cannot be created</source>
        <translation>无法创建会话文件</translation>
    </message>
    <message>
        <source>the session file cannot be opened</source>
        <translation>无法打开会话文件</translation>
    </message>
    <message>
        <source>the session file cannot be repaired</source>
        <translation>无法修复会话文件</translation>
    </message>
    <message>
        <source>the session file is damaged</source>
        <translation>会话文件已损坏</translation>
    </message>
    <message>
        <source>the session file was not closed cleanly</source>
        <translation>会话文件未正常关闭</translation>
    </message>
    <message>
        <source>the session has others</source>
        <translation>会话中有其他的</translation>
    </message>
    <message>
        <source>the session is closed</source>
        <translation>会话已关闭</translation>
    </message>
    <message>
        <source>the setup is missing</source>
        <translation>缺少设置</translation>
    </message>
    <message>
        <source>the setup is senseless</source>
        <translation>设置无意义</translation>
    </message>
    <message>
        <source>the size in its header is wrong, or the file is cut off</source>
        <translation>文件头中的大小有误，或文件被截断</translation>
    </message>
    <message>
        <source>the slew limit must be above zero</source>
        <translation>变化率限制必须大于零</translation>
    </message>
    <message>
        <source>the span from %1 is empty</source>
        <translation>自 %1 起的时段为空</translation>
    </message>
    <message>
        <source>the span holds no samples</source>
        <translation>该时段没有采样</translation>
    </message>
    <message>
        <source>the speed must be above zero</source>
        <translation>转速必须大于零</translation>
    </message>
    <message>
        <source>the speed range is empty</source>
        <translation>转速范围为空</translation>
    </message>
    <message>
        <source>the speed range must rise from above 0 to at most 300 %</source>
        <translation>转速范围必须从大于 0 递增，不超过 300 %</translation>
    </message>
    <message>
        <source>the step between speeds must be above zero</source>
        <translation>转速步长必须大于零</translation>
    </message>
    <message>
        <source>the step must lie between 0 and 1</source>
        <translation>步长必须在 0 到 1 之间</translation>
    </message>
    <message>
        <source>the table of blocks cannot be read</source>
        <translation>数据块表无法读取</translation>
    </message>
    <message>
        <source>the tangential coefficient must be above zero</source>
        <translation>切向系数必须大于零</translation>
    </message>
    <message>
        <source>the time column does not grow</source>
        <translation>时间列不递增</translation>
    </message>
    <message>
        <source>the time does not rise</source>
        <translation>时间不递增</translation>
    </message>
    <message>
        <source>the time repeats</source>
        <translation>时间重复</translation>
    </message>
    <message>
        <source>the time runs backwards</source>
        <translation>时间倒退</translation>
    </message>
    <message>
        <source>the time steps are uneven</source>
        <translation>时间步长不均匀</translation>
    </message>
    <message>
        <source>the tone is cut off at the input&apos;s limit</source>
        <translation>音在输入极限处被削波</translation>
    </message>
    <message>
        <source>the tool has %1 teeth</source>
        <translation>刀具有 %1 齿</translation>
    </message>
    <message>
        <source>the tool&apos;s cutting speed lies below the speed range</source>
        <translation>刀具切削速度低于转速范围</translation>
    </message>
    <message>
        <source>the tool&apos;s cutting speed must be above zero</source>
        <translation>刀具切削速度必须大于零</translation>
    </message>
    <message>
        <source>the value is not a finite number</source>
        <translation>该值不是有限数</translation>
    </message>
    <message>
        <source>the work-holder needs a flexure with frequency, damping and stiffness</source>
        <translation>工件夹具需要具有频率、阻尼和刚度的柔性铰</translation>
    </message>
    <message>
        <source>the work-holder&apos;s filter and amplifier need a bandwidth and a slew limit</source>
        <translation>工件夹具的滤波器和放大器需要带宽与变化率限制</translation>
    </message>
    <message>
        <source>the work-holder&apos;s lines to quieten must be positive frequencies</source>
        <translation>工件夹具需抑制的谱线必须为正频率</translation>
    </message>
    <message>
        <source>the work-holder&apos;s stroke must be above zero and at most 1 mm</source>
        <translation>工件夹具的行程必须大于零且不超过 1 mm</translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>现有：%1</translation>
    </message>
    <message>
        <source>there is no channel %1</source>
        <translation>没有通道 %1</translation>
    </message>
    <message>
        <source>there is no clock here</source>
        <translation>此处没有时钟</translation>
    </message>
    <message>
        <source>there is no plant to drive</source>
        <translation>没有可驱动的对象</translation>
    </message>
    <message>
        <source>there is no such array in the file</source>
        <translation>文件中没有此数组</translation>
    </message>
    <message>
        <source>there is no such data set or folder in the file</source>
        <translation>文件中没有此数据集或文件夹</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>there is no trigger &apos;%1&apos; at %2</source>
        <translation>%2 处没有触发器 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no wire to a real device here</source>
        <translation>此处没有通往真实设备的连线</translation>
    </message>
    <message>
        <source>there is no wire to a real machine here</source>
        <translation>此处没有通往真实机床的连线</translation>
    </message>
    <message>
        <source>there is nothing to exchange it with</source>
        <translation>没有可与之交换的</translation>
    </message>
    <message>
        <source>they must rise</source>
        <translation>必须递增</translation>
    </message>
    <message>
        <source>this HDF5 library cannot repair files</source>
        <translation>此 HDF5 库不能修复文件</translation>
    </message>
    <message>
        <source>this is no text recording</source>
        <translation>这不是文本记录</translation>
    </message>
    <message>
        <source>this program reads versions %1 to %2</source>
        <translation>本程序可读版本 %1 至 %2</translation>
    </message>
    <message>
        <source>this program was built without alsa-lib</source>
        <translation>本程序构建时没有 alsa-lib</translation>
    </message>
    <message>
        <source>this recording cannot be gone back in</source>
        <translation>此记录不能后退</translation>
    </message>
    <message>
        <source>too short</source>
        <translation>太短</translation>
    </message>
    <message>
        <source>too short to identify a path from</source>
        <translation>太短，无法辨识路径</translation>
    </message>
    <message>
        <source>turns too slowly for its rate</source>
        <translation>相对采样率转得太慢</translation>
    </message>
    <message>
        <source>two devices or more are joined: 1_id, 2_id ...</source>
        <translation>两个或更多设备相连：1_id、2_id ……</translation>
    </message>
    <message>
        <source>two seconds are needed</source>
        <translation>需要两秒</translation>
    </message>
    <message>
        <source>two seconds of the tone are needed</source>
        <translation>需要两秒的音</translation>
    </message>
    <message>
        <source>unevenness must lie between 0 and 0.01 / sqrt(Hz)</source>
        <translation>不均匀度必须在 0 到 0.01 / sqrt(Hz) 之间</translation>
    </message>
    <message>
        <source>unknown id &apos;%1&apos;</source>
        <translation>未知标识 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos;</source>
        <translation>未知键 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>up to 64 can be read</source>
        <translation>最多可读 64 个</translation>
    </message>
    <message>
        <source>use the link &apos;simulated&apos;</source>
        <translation>请用连接 &apos;simulated&apos;</translation>
    </message>
    <message>
        <source>virtual data sets are not read</source>
        <translation>不读取虚拟数据集</translation>
    </message>
    <message>
        <source>volts of one device unit, for example of full scale</source>
        <translation>一个设备单位的电压，例如满量程</translation>
    </message>
    <message>
        <source>wait for the end</source>
        <translation>请等待结束</translation>
    </message>
    <message>
        <source>what full scale means must be a number other than 0</source>
        <translation>满量程的含义必须为非零数</translation>
    </message>
    <message>
        <source>what is there is left as it is</source>
        <translation>现有内容保持不变</translation>
    </message>
    <message>
        <source>what would the machine watch?</source>
        <translation>机床该监视什么？</translation>
    </message>
    <message>
        <source>without it nothing can be told or done</source>
        <translation>没有它就无从判断或动作</translation>
    </message>
    <message>
        <source>x and y are on the same channel</source>
        <translation>x 和 y 在同一通道上</translation>
    </message>
    <message>
        <source>zeroth order averages the force (a tooth cuts %1 % of the time): expect errors of tens of percent between the lobes; the exact method has none</source>
        <translation>零阶法对力取平均（一齿 %1 % 的时间在切削）：叶瓣之间会有百分之几十的误差；精确法没有</translation>
    </message>
    <message>
        <source>zeroth order averages the force although a tooth cuts only %1 % of the time: limits can be far too high, flip lobes and islands are missing; use the exact method</source>
        <translation>零阶法对力取平均，而一齿只有 %1 % 的时间在切削：极限可能高得多，缺少倍周期叶瓣与岛；请用精确法</translation>
    </message>
    <message>
        <source>cannot be read as TOML</source>
        <translation>不能按 TOML 读取</translation>
    </message>
    <message>
        <source>%1 is above %2 of %3</source>
        <translation>%1 高于 %3 的 %2</translation>
    </message>
    <message>
        <source>must be above fuzzy.energy-reference</source>
        <translation>必须大于 fuzzy.energy-reference</translation>
    </message>
    <message>
        <source>rules must fall as coherence rises</source>
        <translation>相干性升高时规则值必须下降</translation>
    </message>
    <message>
        <source>A machine state older than this is stale; auto: three of the link&apos;s own periods and a block</source>
        <translation>早于此的机床状态视为过时；auto：连接自身周期的三倍再加一个数据块</translation>
    </message>
    <message>
        <source>every machine state would be stale</source>
        <translation>每个机床状态都会过时</translation>
    </message>
    <message>
        <source>no override could be seen in force in time</source>
        <translation>任何倍率都来不及确认生效</translation>
    </message>
    <message>
        <source>the link reads the machine every %1 ms: at least two of its periods</source>
        <translation>连接每 %1 ms 读取一次机床：至少两个周期</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>按设定值</translation>
    </message>
    <message>
        <source>a quarter of the told spindle frequency</source>
        <translation>给定主轴频率的四分之一</translation>
    </message>
    <message>
        <source>low enough for any spindle, as no speed was told</source>
        <translation>对任何主轴都够低，因为没有给定转速</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>nobody has told it, and the signal has not shown it</source>
        <translation>无人给定，信号也未显示</translation>
    </message>
    <message>
        <source>as told</source>
        <translation>按给定值</translation>
    </message>
    <message>
        <source>as the machine reads it</source>
        <translation>按机床读数</translation>
    </message>
    <message>
        <source>found in the signal, and followed</source>
        <translation>在信号中找到并跟踪</translation>
    </message>
    <message>
        <source>no speed is known</source>
        <translation>转速未知</translation>
    </message>
    <message>
        <source>of what was told</source>
        <translation>给定值的</translation>
    </message>
    <message>
        <source>of what the signal shows</source>
        <translation>信号所示值的</translation>
    </message>
    <message>
        <source>Noise in air, channel 1</source>
        <translation>空切噪声，通道 1</translation>
    </message>
    <message>
        <source>no air has been heard yet</source>
        <translation>尚未听到空切</translation>
    </message>
    <message>
        <source>the quietest fifth of a second so far</source>
        <translation>迄今最安静的五分之一秒</translation>
    </message>
    <message>
        <source>Noise in air, channel 2</source>
        <translation>空切噪声，通道 2</translation>
    </message>
    <message>
        <source>Noise in air, channel 3</source>
        <translation>空切噪声，通道 3</translation>
    </message>
    <message>
        <source>Noise in air, channel 4</source>
        <translation>空切噪声，通道 4</translation>
    </message>
    <message>
        <source>as many as the working rate hears at this speed</source>
        <translation>该转速下工作采样率所能听到的全部</translation>
    </message>
    <message>
        <source>32, where the forced vibration of most cuts ends</source>
        <translation>32：多数切削的强迫振动到此为止</translation>
    </message>
    <message>
        <source>a memory of two turns at this speed</source>
        <translation>该转速下两转的记忆</translation>
    </message>
    <message>
        <source>leaves 1 % of each harmonic</source>
        <translation>每个谐波留下 1 %</translation>
    </message>
    <message>
        <source>thinned by a whole factor to the paper&apos;s 10 kHz or somewhat more</source>
        <translation>按整数倍抽取到论文的 10 kHz 或稍高</translation>
    </message>
    <message>
        <source>the sampling rate itself</source>
        <translation>采样率本身</translation>
    </message>
    <message>
        <source>not yet: it is learned in the steady cut</source>
        <translation>尚无：在稳定进行的切削中学习</translation>
    </message>
    <message>
        <source>four times the noise floor, or the least growth that counts</source>
        <translation>噪声底的四倍，或计入的最小增长</translation>
    </message>
    <message>
        <source>Scale of the signal</source>
        <translation>信号的尺度</translation>
    </message>
    <message>
        <source>mean of the stable cut so far</source>
        <translation>迄今稳定切削的平均值</translation>
    </message>
    <message>
        <source>held while an alarm lasts</source>
        <translation>报警期间保持不变</translation>
    </message>
    <message>
        <source>Noise floor</source>
        <translation>噪声底</translation>
    </message>
    <message>
        <source>28 turns at the told speed</source>
        <translation>给定转速下的 28 转</translation>
    </message>
    <message>
        <source>1.5 s, the most, which 28 turns would exceed</source>
        <translation>1.5 s，上限；28 转会超过它</translation>
    </message>
    <message>
        <source>the paper&apos;s, as no speed was told</source>
        <translation>论文的值，因为没有给定转速</translation>
    </message>
    <message>
        <source>as many as the sampling rate hears at this speed</source>
        <translation>该转速下采样率所能听到的全部</translation>
    </message>
    <message>
        <source>the least there are, for a tool of few teeth</source>
        <translation>最少数目，用于齿数少的刀具</translation>
    </message>
    <message>
        <source>12 tooth passings</source>
        <translation>12 次齿通</translation>
    </message>
    <message>
        <source>Growth that is an onset</source>
        <translation>视为起振的增长</translation>
    </message>
    <message>
        <source>four times the noise floor in energy</source>
        <translation>噪声底能量的四倍</translation>
    </message>
    <message>
        <source>the smallest onset, as set, which the noise does not reach</source>
        <translation>按设定的最小起振值，噪声达不到它</translation>
    </message>
    <message>
        <source>12 turns at the told speed</source>
        <translation>给定转速下的 12 转</translation>
    </message>
    <message>
        <source>the paper&apos;s, which 12 turns would exceed</source>
        <translation>论文的值；12 转会超过它</translation>
    </message>
    <message>
        <source>12 turns of a slow spindle, as no speed was told</source>
        <translation>慢速主轴的 12 转，因为没有给定转速</translation>
    </message>
    <message>
        <source>of what changes from turn to turn: four times the noise floor, or the least that counts</source>
        <translation>针对逐转变化的部分：噪声底的四倍，或计入的最小值</translation>
    </message>
    <message>
        <source>Usual coherence</source>
        <translation>通常的相干</translation>
    </message>
    <message>
        <source>noise, full scale, step, counts and bandwidth must not be negative</source>
        <translation>噪声、满量程、步长、计数和带宽不能为负</translation>
    </message>
    <message>
        <source>the torque loop&apos;s bandwidth must not be negative</source>
        <translation>转矩环的带宽不能为负</translation>
    </message>
    <message>
        <source>Energy ratio (eq. 28) from which a cut is in full chatter; more where it is high in the calm cut</source>
        <translation>达到此能量比（式 28）即为完全颤振；平稳切削时该值已高的通道要求更高</translation>
    </message>
    <message>
        <source>Full chatter</source>
        <translation>完全颤振</translation>
    </message>
    <message>
        <source>the chatter ratio, as set</source>
        <translation>颤振比，按设定</translation>
    </message>
    <message>
        <source>four times what the channel has in the calm cut</source>
        <translation>该通道在平稳切削时的四倍</translation>
    </message>
    <message>
        <source>&apos;%1&apos; converts, or stands before what does, which may change the rate and mix channels; hw: names the device itself</source>
        <translation>“%1”会转换，或位于会转换的设备之前，可能改变采样率并混合通道；用 hw: 指定设备本身</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a sound server&apos;s, which may change the rate and mix channels; hw: names the device itself</source>
        <translation>“%1”属于声音服务器，可能改变采样率并混合通道；用 hw: 指定设备本身</translation>
    </message>
    <message>
        <source>0 to 400 %</source>
        <translation>0 至 400 %</translation>
    </message>
    <message>
        <source>HDF5: %1</source>
        <translation>HDF5: %1</translation>
    </message>
    <message>
        <source>[[volts, value], [volts, value], ...]</source>
        <translation>[[伏，值]，[伏，值]，...]</translation>
    </message>
    <message>
        <source>[volts, value]</source>
        <translation>[伏，值]</translation>
    </message>
    <message>
        <source>allowed: %1 to %2, or auto</source>
        <translation>允许：%1 至 %2，或 auto</translation>
    </message>
    <message>
        <source>cannot be tried</source>
        <translation>无法尝试</translation>
    </message>
    <message>
        <source>cannot be tried: %1 does not start</source>
        <translation>无法尝试：%1 不能启动</translation>
    </message>
    <message>
        <source>cannot be written here</source>
        <translation>不能写在这里</translation>
    </message>
    <message>
        <source>cannot be written: more than 268 million samples a channel</source>
        <translation>无法写入：每通道超过 2.68 亿个采样</translation>
    </message>
    <message>
        <source>cannot be written: too many samples for this format</source>
        <translation>无法写入：采样对此格式过多</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; holds &apos;%2&apos;</source>
        <translation>列“%1”包含“%2”</translation>
    </message>
    <message>
        <source>export a span, or to .h5</source>
        <translation>导出一段，或导出为 .h5</translation>
    </message>
    <message>
        <source>input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>is &apos;%1&apos;</source>
        <translation>是“%1”</translation>
    </message>
    <message>
        <source>it samples at %1, and could at %2</source>
        <translation>以 %1 采样，也可以用 %2</translation>
    </message>
    <message>
        <source>output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>rms in %1, or as &quot;1 g&quot;</source>
        <translation>%1 的有效值，或写作 &quot;1 g&quot;</translation>
    </message>
    <message>
        <source>rms in %1, or as &quot;94 dB&quot;</source>
        <translation>%1 的有效值，或写作 &quot;94 dB&quot;</translation>
    </message>
    <message>
        <source>stillcut --report IN OUT makes reports and pictures</source>
        <translation>stillcut --report IN OUT 生成报告和图片</translation>
    </message>
    <message>
        <source>the HDF5 library cannot read it</source>
        <translation>HDF5 库无法读取</translation>
    </message>
    <message>
        <source>the longest was %1 of %2: samples are lost again and again</source>
        <translation>最长的是 %2 中的 %1：采样一再丢失</translation>
    </message>
    <message>
        <source>the program stillcut-reader is missing beside this one</source>
        <translation>旁边缺少程序 stillcut-reader</translation>
    </message>
    <message>
        <source>the suffix must be one of %1</source>
        <translation>后缀必须是 %1 之一</translation>
    </message>
    <message>
        <source>toml++: %1</source>
        <translation>toml++: %1</translation>
    </message>
    <message>
        <source>universal file</source>
        <translation>通用文件</translation>
    </message>
    <message>
        <source>use .h5</source>
        <translation>请用 .h5</translation>
    </message>
    <message>
        <source>the log cannot be written there</source>
        <translation>无法在该处写入日志</translation>
    </message>
    <message>
        <source>nests tables too deeply: no file of settings</source>
        <translation>表嵌套过深：不是设置文件</translation>
    </message>
    <message>
        <source>another Stillcut holds this machine (process %1)</source>
        <translation>另一个 Stillcut 正在占用这台机床（进程 %1）</translation>
    </message>
    <message>
        <source>end that one, or watch here without a machine link</source>
        <translation>请结束那一个，或在此不连接机床仅作监视</translation>
    </message>
    <message>
        <source>its state is on the page Operate; to try the link, end the run first</source>
        <translation>其状态显示在“操作”页；要测试连接，请先结束当前运行</translation>
    </message>
    <message>
        <source>the run that is going on holds this machine</source>
        <translation>正在进行的运行占用着这台机床</translation>
    </message>
    <message>
        <source>%1 was cut short by another program</source>
        <translation>%1 被其他程序截短</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no question to a session</source>
        <translation>“%1”不是对会话的查询</translation>
    </message>
    <message>
        <source>&apos;%1&apos; reads %2, which can not be</source>
        <translation>“%1”读数为 %2，这不可能</translation>
    </message>
    <message>
        <source>a Stillcut that was killed left spindle %1 %, feed %2 %; the operator had %3 %, %4 %: BACK TO 100 % brings that back</source>
        <translation>被强制结束的 Stillcut 留下主轴 %1 %、进给 %2 %；操作者原为 %3 %、%4 %：按“恢复 100 %”可还原</translation>
    </message>
    <message>
        <source>a float has two words and a sign of its own, and is no flag</source>
        <translation>浮点数占两个字、自带符号，不是标志位</translation>
    </message>
    <message>
        <source>is its entry in the register map right?</source>
        <translation>寄存器表中的条目是否正确？</translation>
    </message>
    <message>
        <source>is no session that can be looked into</source>
        <translation>不是可以查看内容的会话</translation>
    </message>
    <message>
        <source>is not below &apos;highest&apos;</source>
        <translation>不低于 &apos;highest&apos;</translation>
    </message>
    <message>
        <source>is the sender running there, and connected to its machine?</source>
        <translation>发送程序是否在那里运行并已连接到机器？</translation>
    </message>
    <message>
        <source>is there already</source>
        <translation>已存在</translation>
    </message>
    <message>
        <source>is true beside &apos;words = 1&apos;, &apos;signed&apos; or &apos;bit&apos;</source>
        <translation>与 &apos;words = 1&apos;、&apos;signed&apos; 或 &apos;bit&apos; 同时为真</translation>
    </message>
    <message>
        <source>no value would be believed</source>
        <translation>任何值都不会被采信</translation>
    </message>
    <message>
        <source>recording stopped: the file was cut short by another program</source>
        <translation>记录已停止：文件被其他程序截短</translation>
    </message>
    <message>
        <source>the header promises %1 bytes of samples, the file holds %2, which are read: its recorder did not end it</source>
        <translation>文件头声明有 %1 字节样本，文件实际含 %2 字节，已读取：录制程序没有正常结束该文件</translation>
    </message>
    <message>
        <source>this folder has no file locks, without which a recording is not safe (%1)</source>
        <translation>此文件夹不支持文件锁，没有文件锁记录就不安全（%1）</translation>
    </message>
    <message>
        <source>spindle programmed %1 rpm, not measured</source>
        <translation>主轴编程转速 %1 r/min，未测量</translation>
    </message>
    <message>
        <source>an order was seen to act, and to be taken back, after %1 ms</source>
        <translation>已观察到指令生效并被撤回，用时 %1 ms</translation>
    </message>
    <message>
        <source>no order has shown it yet: nothing was moved</source>
        <translation>尚无指令证实：未移动任何倍率</translation>
    </message>
    <message>
        <source>Sender</source>
        <translation>发送程序</translation>
    </message>
    <message>
        <source>Sender port</source>
        <translation>发送程序端口</translation>
    </message>
    <message>
        <source>Sender name</source>
        <translation>发送程序用户名</translation>
    </message>
    <message>
        <source>Sender password</source>
        <translation>发送程序密码</translation>
    </message>
    <message>
        <source>Uncertainty of the speed</source>
        <translation>转速的不确定度</translation>
    </message>
    <message>
        <source>%1 of %2 rows hold no number where one belongs and are missing; the first: %3</source>
        <translation>%2 行中有 %1 行缺少数字，按缺失处理；第一处：%3</translation>
    </message>
    <message>
        <source>%1; the machine before runs again, authority is Off</source>
        <translation>%1；之前的机床已重新运行，权限为关闭</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no row of numbers</source>
        <translation>“%1”不是数字行</translation>
    </message>
    <message>
        <source>a section of the tool has no length or no diameter</source>
        <translation>刀具有一段没有长度或直径</translation>
    </message>
    <message>
        <source>a spread must lie between 0 and 50 %</source>
        <translation>离散度必须在 0 到 50 % 之间</translation>
    </message>
    <message>
        <source>channel &apos;%1&apos; is left out: %2 beside %3</source>
        <translation>略去通道“%1”：%2，其余为 %3</translation>
    </message>
    <message>
        <source>close it there, or run h5clear -s on a copy of it</source>
        <translation>请在写入程序中关闭，或对其副本运行 h5clear -s</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; is left out: most of its cells hold no number</source>
        <translation>略去列“%1”：其大部分单元格没有数字</translation>
    </message>
    <message>
        <source>commas seem to be both decimal signs and delimiters</source>
        <translation>逗号似乎既是小数点又是分隔符</translation>
    </message>
    <message>
        <source>convert it to WAV: ffmpeg -i FILE cut.wav</source>
        <translation>请转换为 WAV：ffmpeg -i FILE cut.wav</translation>
    </message>
    <message>
        <source>export it as CSV, or write it as HDF5 in Python: %1</source>
        <translation>请导出为 CSV，或在 Python 中写成 HDF5：%1</translation>
    </message>
    <message>
        <source>export with decimal points and without signs between thousands</source>
        <translation>请使用小数点并去掉千位分隔符导出</translation>
    </message>
    <message>
        <source>export with decimal points, or with semicolons between the columns</source>
        <translation>请使用小数点导出，或用分号分隔各列</translation>
    </message>
    <message>
        <source>has other lines than %1</source>
        <translation>谱线与 %1 不同</translation>
    </message>
    <message>
        <source>helix needs one angle per tooth</source>
        <translation>螺旋角须每齿一个</translation>
    </message>
    <message>
        <source>holds %1 sound tracks, of which one is read</source>
        <translation>含有 %1 条音轨，读取其中一条</translation>
    </message>
    <message>
        <source>holds a sample that is not a finite number</source>
        <translation>含有非有限数的采样值</translation>
    </message>
    <message>
        <source>holds no array of real numbers in one or two dimensions</source>
        <translation>不含一维或二维的实数数组</translation>
    </message>
    <message>
        <source>holds no line above 0 Hz</source>
        <translation>没有 0 Hz 以上的谱线</translation>
    </message>
    <message>
        <source>holds no sound track</source>
        <translation>没有音轨</translation>
    </message>
    <message>
        <source>is a ZIP archive above 4 GiB</source>
        <translation>是大于 4 GiB 的 ZIP 压缩包</translation>
    </message>
    <message>
        <source>is a file of the format %1, which is not read</source>
        <translation>是 %1 格式的文件，不支持读取</translation>
    </message>
    <message>
        <source>is a phone&apos;s or a camera&apos;s file, and this Stillcut was built without the decoder for them</source>
        <translation>是手机或相机的文件，而此 Stillcut 未包含相应解码器</translation>
    </message>
    <message>
        <source>is damaged %1 s from its beginning: what is before is read</source>
        <translation>在开始后 %1 s 处损坏：读取此前的部分</translation>
    </message>
    <message>
        <source>it follows from the indentation coefficient and the wear land</source>
        <translation>它由压入系数和磨损带宽度得出</translation>
    </message>
    <message>
        <source>it is not clear whether &apos;%1&apos; has a decimal comma or thousands set apart</source>
        <translation>不清楚“%1”中的逗号是小数点还是千位分隔符</translation>
    </message>
    <message>
        <source>its container cannot be read</source>
        <translation>无法读取其容器格式</translation>
    </message>
    <message>
        <source>its header says %1 Hz, its times %2 Hz, which are taken</source>
        <translation>文件头为 %1 Hz，时间列为 %2 Hz，采用后者</translation>
    </message>
    <message>
        <source>its sampling rate or number of channels changes within it</source>
        <translation>其采样率或通道数在文件中途改变</translation>
    </message>
    <message>
        <source>its times do not grow</source>
        <translation>时间不递增</translation>
    </message>
    <message>
        <source>line %1, the last, is cut off and left out</source>
        <translation>最后一行（第 %1 行）不完整，已略去</translation>
    </message>
    <message>
        <source>measure both with the same sampling rate and length</source>
        <translation>两者要用相同的采样率和长度测量</translation>
    </message>
    <message>
        <source>name every column</source>
        <translation>请为每一列命名</translation>
    </message>
    <message>
        <source>needs its distance from the face</source>
        <translation>需要到端面的距离</translation>
    </message>
    <message>
        <source>needs the tool&apos;s diameter and stick-out</source>
        <translation>需要刀具的直径和伸出长度</translation>
    </message>
    <message>
        <source>no decoder for its sound track</source>
        <translation>没有可解码其音轨的解码器</translation>
    </message>
    <message>
        <source>no sample of its sound track can be decoded</source>
        <translation>其音轨无法解码出任何采样值</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>open the .tdms file beside it</source>
        <translation>请打开旁边的 .tdms 文件</translation>
    </message>
    <message>
        <source>open the recording that it was made from</source>
        <translation>请打开生成它的原始记录</translation>
    </message>
    <message>
        <source>raise the lowest speed</source>
        <translation>请提高最低转速</translation>
    </message>
    <message>
        <source>samples must be 8 to 1000</source>
        <translation>样本数必须为 8 到 1000</translation>
    </message>
    <message>
        <source>save plain arrays with numpy.save or numpy.savez</source>
        <translation>请用 numpy.save 或 numpy.savez 保存普通数组</translation>
    </message>
    <message>
        <source>save the sheet as CSV</source>
        <translation>请将工作表另存为 CSV</translation>
    </message>
    <message>
        <source>semi-discretization needs teeth of one pitch and one helix</source>
        <translation>半离散法要求各齿齿距和螺旋角相同</translation>
    </message>
    <message>
        <source>semi-discretization with %1 cells is too coarse below %2 rpm: take %3 or more, or the exact method</source>
        <translation>%1 个单元的半离散法在 %2 rpm 以下过粗：请取 %3 个以上，或用精确方法</translation>
    </message>
    <message>
        <source>some columns end after %1 of %2 rows, where the recording ends; --channel N reads one alone</source>
        <translation>部分列在 %2 行中的第 %1 行后结束，记录到此为止；--channel N 可单独读取一列</translation>
    </message>
    <message>
        <source>take a smaller depth or other helix angles</source>
        <translation>请减小切深或改用其他螺旋角</translation>
    </message>
    <message>
        <source>teeth must be 1 to %1, not %2</source>
        <translation>齿数必须为 1 到 %1，而不是 %2</translation>
    </message>
    <message>
        <source>the HDF5 file was not closed by its writer</source>
        <translation>HDF5 文件未被写入程序关闭</translation>
    </message>
    <message>
        <source>the ZIP archive is damaged</source>
        <translation>ZIP 压缩包已损坏</translation>
    </message>
    <message>
        <source>the angles make it %1</source>
        <translation>由角度得出 %1</translation>
    </message>
    <message>
        <source>the decoder cannot read it</source>
        <translation>解码器无法读取</translation>
    </message>
    <message>
        <source>the edges of two teeth meet at %1 mm</source>
        <translation>两个刀齿的切削刃在 %1 mm 处相交</translation>
    </message>
    <message>
        <source>the exact method takes any</source>
        <translation>精确方法可用于任意刀齿</translation>
    </message>
    <message>
        <source>the exit angle must lie above the start angle</source>
        <translation>切出角必须大于切入角</translation>
    </message>
    <message>
        <source>the flutes are longer than the stick-out</source>
        <translation>容屑槽比伸出长度还长</translation>
    </message>
    <message>
        <source>the flutes&apos; effective diameter must be 0.3 to 1 of the tool&apos;s</source>
        <translation>容屑槽的等效直径必须是刀具直径的 0.3 到 1 倍</translation>
    </message>
    <message>
        <source>the header does not say how much follows, as of a recorder that wrote into a pipe: all is read</source>
        <translation>文件头未说明数据长度（如录音程序写入管道）：全部读取</translation>
    </message>
    <message>
        <source>the header&apos;s size is not true: it says %1 bytes, which is what 32 bits leave of %2, which are read</source>
        <translation>文件头中的大小不正确：写着 %1 字节，这是 %2 字节在 32 位下的余数，按后者读取</translation>
    </message>
    <message>
        <source>the holder was measured with an exponential window: the damping is too high by %1 1/s</source>
        <translation>刀柄测量时用了指数窗：阻尼偏大 %1 1/s</translation>
    </message>
    <message>
        <source>the holder&apos;s rotation was not measured and is left out: the tip is softer, and its frequencies are lower, than computed here; --cross measures it</source>
        <translation>没有测量刀柄的转动，已忽略：刀尖比这里算出的更软，频率更低；用 --cross 测量</translation>
    </message>
    <message>
        <source>the speed range holds more lobes than can be looked at</source>
        <translation>转速范围内的叶瓣过多，无法逐一检查</translation>
    </message>
    <message>
        <source>the tool needs 1 to 64 sections</source>
        <translation>刀具需要 1 到 64 段</translation>
    </message>
    <message>
        <source>the tool&apos;s material is none</source>
        <translation>刀具的材料无效</translation>
    </message>
    <message>
        <source>the unit &apos;%1&apos; of its time is not known</source>
        <translation>时间单位“%1”未知</translation>
    </message>
    <message>
        <source>the zeroth order leaves out process damping: its limits at low speed are too low</source>
        <translation>零阶法忽略过程阻尼：低速下的极限偏低</translation>
    </message>
    <message>
        <source>the zeroth order needs teeth of one pitch and one helix</source>
        <translation>零阶法要求各齿齿距和螺旋角相同</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>unpack it, and open what is in it</source>
        <translation>请解压后打开其中的文件</translation>
    </message>
    <message>
        <source>was not closed by its writer: what that had written so far is read</source>
        <translation>未被写入程序关闭：读取已写入的部分</translation>
    </message>
    <message>
        <source>what is clamped does not count</source>
        <translation>夹持部分不计算在内</translation>
    </message>
    <message>
        <source>what stands below the rows is left out: %1</source>
        <translation>略去数据行下方的内容：%1</translation>
    </message>
    <message>
        <source>with decimal commas, export with semicolons between the columns</source>
        <translation>使用逗号作小数点时，请用分号分隔各列导出</translation>
    </message>
    <message>
        <source>with this offset a part of the cut lies beyond the tool</source>
        <translation>按此偏置，部分切削宽度超出刀具</translation>
    </message>
    <message>
        <source>write it as CSV in Python: %1</source>
        <translation>请在 Python 中写成 CSV：%1</translation>
    </message>
    <message>
        <source>%1 s of air cutting</source>
        <translation>空切 %1 s</translation>
    </message>
    <message>
        <source>%1 samples a second are too few for vibration</source>
        <translation>每秒 %1 个采样不足以测量振动</translation>
    </message>
    <message>
        <source>%1; take %2</source>
        <translation>%1；请%2</translation>
    </message>
    <message>
        <source>channel %1 (%2) is no vibration and was left out: %3</source>
        <translation>通道 %1（%2）不是振动信号，已略去：%3</translation>
    </message>
    <message>
        <source>channel %1 (%2) was not in order for %3 s: %4</source>
        <translation>通道 %1（%2）有 %3 s 异常：%4</translation>
    </message>
    <message>
        <source>chatter at %1 Hz from %2 s on</source>
        <translation>%2 s 起出现 %1 Hz 颤振</translation>
    </message>
    <message>
        <source>chatter from %1 s on</source>
        <translation>%1 s 起出现颤振</translation>
    </message>
    <message>
        <source>chatter can be detected up to %1 Hz</source>
        <translation>可检测最高 %1 Hz 的颤振</translation>
    </message>
    <message>
        <source>it grows evenly and falls back, as an angle or a counter does</source>
        <translation>均匀增长后回落，如角度或计数器</translation>
    </message>
    <message>
        <source>it is constant</source>
        <translation>数值恒定</translation>
    </message>
    <message>
        <source>it knows two values only, as a tacho or a switch does</source>
        <translation>只有两个值，如转速脉冲或开关</translation>
    </message>
    <message>
        <source>it only counts, as a row number or a time does</source>
        <translation>只是计数，如行号或时间</translation>
    </message>
    <message>
        <source>judged %1 of %2 s</source>
        <translation>已判定 %2 s 中的 %1 s</translation>
    </message>
    <message>
        <source>judged %1 of %2 s; the rest: %3</source>
        <translation>已判定 %2 s 中的 %1 s；其余：%3</translation>
    </message>
    <message>
        <source>learning the stable cut</source>
        <translation>正在学习稳定切削</translation>
    </message>
    <message>
        <source>less depth</source>
        <translation>减小切深</translation>
    </message>
    <message>
        <source>less than %1 mm of depth</source>
        <translation>切深小于 %1 mm</translation>
    </message>
    <message>
        <source>no chatter</source>
        <translation>无颤振</translation>
    </message>
    <message>
        <source>no speed follows while the number of teeth is not known</source>
        <translation>齿数未知，无法得出转速</translation>
    </message>
    <message>
        <source>no speed follows while the spindle speed is not known</source>
        <translation>主轴转速未知，无法得出转速</translation>
    </message>
    <message>
        <source>no speed in reach is stable at a depth of %1 mm, %2 mm at %3 rpm would be</source>
        <translation>切深 %1 mm 时没有可达的稳定转速，%3 r/min 时 %2 mm 可稳定</translation>
    </message>
    <message>
        <source>no stable speed lies between %1 and %2 rpm</source>
        <translation>%1 至 %2 r/min 之间没有稳定转速</translation>
    </message>
    <message>
        <source>not judged: %1</source>
        <translation>未判定：%1</translation>
    </message>
    <message>
        <source>not judged: no cut was measured</source>
        <translation>未判定：没有听到切削</translation>
    </message>
    <message>
        <source>not judged: only %1 of %2 s in the cut could be, mainly because %3</source>
        <translation>未判定：切削中 %2 s 只有 %1 s 可判定，主要原因：%3</translation>
    </message>
    <message>
        <source>samples are missing</source>
        <translation>缺少采样</translation>
    </message>
    <message>
        <source>stable speeds are only %1 rpm apart here, so that less depth is the surer way</source>
        <translation>此处稳定转速仅相隔 %1 r/min，减小切深更可靠</translation>
    </message>
    <message>
        <source>the frequency of the chatter is not known</source>
        <translation>颤振频率未知</translation>
    </message>
    <message>
        <source>the tool enters or leaves</source>
        <translation>刀具切入或切出</translation>
    </message>
    <message>
        <source>try %1 or %2 rpm (%3 or %4 waves of %5 Hz between two teeth instead of %6), or %7</source>
        <translation>试用 %1 或 %2 r/min（两齿之间 %3 或 %4 个 %5 Hz 波，而非 %6），或%7</translation>
    </message>
    <message>
        <source>try %1 rpm (%2 waves of %3 Hz between two teeth instead of %4), or %5</source>
        <translation>试用 %1 r/min（两齿之间 %2 个 %3 Hz 波，而非 %4），或%5</translation>
    </message>
    <message>
        <source>try %1 rpm (stable from %2 to %3 rpm by the lobes), or %4</source>
        <translation>试用 %1 r/min（按叶瓣图在 %2 至 %3 r/min 稳定），或%4</translation>
    </message>
    <message>
        <source>A simulated tap test: hammer and two accelerometers at the tip of a tool: axis, interval_s</source>
        <translation>模拟敲击试验：力锤和刀尖两个加速度计：axis, interval_s</translation>
    </message>
    <message>
        <source>the machine has no watchdog: a process of its own brings the overrides back if this program dies; they stay where both are killed at once, or the cable goes</source>
        <translation>机床没有看门狗：本程序终止时由独立进程恢复倍率；若两者同时被终止或电缆断开，倍率保持不变</translation>
    </message>
    <message>
        <source>as the run that holds the machine tells: nothing more was asked</source>
        <translation>由占用机床的当前运行提供：未另行询问</translation>
    </message>
    <message>
        <source>Aluminium, wrought</source>
        <translation>变形铝合金</translation>
    </message>
    <message>
        <source>Aluminium, cast</source>
        <translation>铸铝</translation>
    </message>
    <message>
        <source>Steel, unalloyed</source>
        <translation>非合金钢</translation>
    </message>
    <message>
        <source>Steel, alloyed, tempered</source>
        <translation>调质合金钢</translation>
    </message>
    <message>
        <source>Cast iron, grey</source>
        <translation>灰铸铁</translation>
    </message>
    <message>
        <source>Titanium alloy</source>
        <translation>钛合金</translation>
    </message>
    <message>
        <source>stillcut-status, beside any screen, for &apos;linuxcnc&apos;</source>
        <translation>stillcut-status，可与任何界面并用，用于 &apos;linuxcnc&apos;</translation>
    </message>
    <message>
        <source>Status port</source>
        <translation>状态端口</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>间隔</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is raw, with a scale that is no straight line</source>
        <translation>“%1”是原始值，其换算不是直线</translation>
    </message>
    <message>
        <source>&apos;status_port&apos; needs &apos;hal_component_port&apos;</source>
        <translation>&apos;status_port&apos; 需要 &apos;hal_component_port&apos;</translation>
    </message>
    <message>
        <source>a header makes no sense</source>
        <translation>文件头无意义</translation>
    </message>
    <message>
        <source>a response along x or y is needed</source>
        <translation>需要 x 或 y 方向的频响</translation>
    </message>
    <message>
        <source>a response needs two lines or more, each with a frequency</source>
        <translation>频响至少需要两条谱线，每条都有频率</translation>
    </message>
    <message>
        <source>a sweep changes the speed by up to 20 % a second</source>
        <translation>转速扫描每秒最多变化 20 %</translation>
    </message>
    <message>
        <source>a sweep needs the speed where it ends</source>
        <translation>转速扫描需要终止转速</translation>
    </message>
    <message>
        <source>a tool with another or an uneven pitch</source>
        <translation>换用不同齿距或不等齿距的刀具</translation>
    </message>
    <message>
        <source>a tooth harmonic meets a resonance: take the speed off it</source>
        <translation>刀齿谐波与共振重合：请避开该转速</translation>
    </message>
    <message>
        <source>a tooth harmonic meets a resonance: take the speed off it, as %1 rpm</source>
        <translation>刀齿谐波与共振重合：请避开该转速，例如 %1 r/min</translation>
    </message>
    <message>
        <source>an incline ends deeper than it begins</source>
        <translation>斜切的终点必须比起点深</translation>
    </message>
    <message>
        <source>another speed: %1 rpm</source>
        <translation>换一个转速：%1 r/min</translation>
    </message>
    <message>
        <source>cannot be kept for the screen</source>
        <translation>无法为屏幕保留</translation>
    </message>
    <message>
        <source>cannot be read again</source>
        <translation>无法再次读取</translation>
    </message>
    <message>
        <source>chatter frequency must lie between 0 and 100 kHz</source>
        <translation>颤振频率必须在 0 与 100 kHz 之间</translation>
    </message>
    <message>
        <source>check runout and balance</source>
        <translation>检查跳动和动平衡</translation>
    </message>
    <message>
        <source>clearance must lie above 0 and up to 1000 mm</source>
        <translation>安全距离必须大于 0 且不超过 1000 mm</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>切削</translation>
    </message>
    <message>
        <source>depth must lie above 0 and up to 1000 mm</source>
        <translation>切深必须大于 0 且不超过 1000 mm</translation>
    </message>
    <message>
        <source>diameter must lie above 0 and up to 1000 mm</source>
        <translation>直径必须大于 0 且不超过 1000 mm</translation>
    </message>
    <message>
        <source>doubt must lie between 0 and 0.5</source>
        <translation>存疑程度必须在 0 与 0.5 之间</translation>
    </message>
    <message>
        <source>export it scaled, or as CSV</source>
        <translation>请导出换算后的数据，或导出为 CSV</translation>
    </message>
    <message>
        <source>feed per tooth must lie above 0 and up to 10 mm</source>
        <translation>每齿进给必须大于 0 且不超过 10 mm</translation>
    </message>
    <message>
        <source>field &apos;%1&apos; is missing or of the wrong kind</source>
        <translation>字段 &apos;%1&apos; 缺失或类型不符</translation>
    </message>
    <message>
        <source>gives no answer</source>
        <translation>没有应答</translation>
    </message>
    <message>
        <source>has a hammer or a frequency response</source>
        <translation>含力锤或频响</translation>
    </message>
    <message>
        <source>holds interleaved values that are no numbers</source>
        <translation>包含交错存放的非数字值</translation>
    </message>
    <message>
        <source>holds modes alone</source>
        <translation>只含模态</translation>
    </message>
    <message>
        <source>holds no channel of numbers</source>
        <translation>不含数字通道</translation>
    </message>
    <message>
        <source>holds no cut &apos;%1&apos;</source>
        <translation>不含切削 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>holds no hit</source>
        <translation>没有敲击</translation>
    </message>
    <message>
        <source>holds no values</source>
        <translation>不含数值</translation>
    </message>
    <message>
        <source>holds unscaled values of a DAQmx device, which are not read</source>
        <translation>包含 DAQmx 设备的未换算数值，无法读取</translation>
    </message>
    <message>
        <source>is a damaged TDMS file</source>
        <translation>是损坏的 TDMS 文件</translation>
    </message>
    <message>
        <source>is a damaged spreadsheet</source>
        <translation>是损坏的电子表格</translation>
    </message>
    <message>
        <source>is a store of a newer version of Stillcut</source>
        <translation>是更新版本 Stillcut 的记录库</translation>
    </message>
    <message>
        <source>is no line of evidence</source>
        <translation>不是切削记录行</translation>
    </message>
    <message>
        <source>is no store of cuts</source>
        <translation>不是切削记录库</translation>
    </message>
    <message>
        <source>is the installation complete?</source>
        <translation>安装是否完整？</translation>
    </message>
    <message>
        <source>it belongs to another program</source>
        <translation>它属于其他程序</translation>
    </message>
    <message>
        <source>it was quiet at %1 rpm</source>
        <translation>在 %1 r/min 时平稳</translation>
    </message>
    <message>
        <source>its decay fits nothing that was learned so far</source>
        <translation>其衰减与目前所学不符</translation>
    </message>
    <message>
        <source>its decay is too uncertain</source>
        <translation>其衰减不够确定</translation>
    </message>
    <message>
        <source>its schema is not %1</source>
        <translation>其模式不是 %1</translation>
    </message>
    <message>
        <source>its speed lies outside what is looked at</source>
        <translation>其转速超出所考察的范围</translation>
    </message>
    <message>
        <source>its values lie too scattered</source>
        <translation>数值存放过于分散</translation>
    </message>
    <message>
        <source>length must lie above 0 and up to 100 m</source>
        <translation>长度必须大于 0 且不超过 100 m</translation>
    </message>
    <message>
        <source>less depth: %1 mm</source>
        <translation>减小切深：%1 mm</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>界限</translation>
    </message>
    <message>
        <source>machine and tool must be named</source>
        <translation>必须给出机床和刀具的名称</translation>
    </message>
    <message>
        <source>modes</source>
        <translation>模态</translation>
    </message>
    <message>
        <source>no free vibration stands out of the noise</source>
        <translation>没有自由振动高出噪声</translation>
    </message>
    <message>
        <source>no recording is open</source>
        <translation>没有打开的记录</translation>
    </message>
    <message>
        <source>one JSON object a line</source>
        <translation>每行一个 JSON 对象</translation>
    </message>
    <message>
        <source>one tooth has no pitch to choose</source>
        <translation>单齿没有齿距可选</translation>
    </message>
    <message>
        <source>pitches are chosen for teeth of one helix</source>
        <translation>只能为同一螺旋角的刀齿选择齿距</translation>
    </message>
    <message>
        <source>say what the tool cuts: %1</source>
        <translation>请填写所切材料：%1</translation>
    </message>
    <message>
        <source>spectra</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>speed must lie above 0 and up to 1e6 rpm</source>
        <translation>转速必须大于 0 且不超过 1e6 r/min</translation>
    </message>
    <message>
        <source>stick-out must lie between 0 and 2000 mm</source>
        <translation>悬伸长度必须在 0 与 2000 mm 之间</translation>
    </message>
    <message>
        <source>stillcut-cli materials lists them</source>
        <translation>stillcut-cli materials 会列出它们</translation>
    </message>
    <message>
        <source>stillcut-status only tells; the overrides go through stillcut-hal</source>
        <translation>stillcut-status 只提供状态；倍率通过 stillcut-hal 调节</translation>
    </message>
    <message>
        <source>take a shorter range of speeds, or less feed</source>
        <translation>请缩小转速范围或减小进给</translation>
    </message>
    <message>
        <source>teeth must be 1 to 200</source>
        <translation>齿数必须为 1 到 200</translation>
    </message>
    <message>
        <source>the file was not finished; what was written until then is read</source>
        <translation>文件未写完；读取已写入的部分</translation>
    </message>
    <message>
        <source>the free vibration is not the same throughout the cut</source>
        <translation>自由振动在切削过程中不一致</translation>
    </message>
    <message>
        <source>the frequencies of a response must rise from above 0</source>
        <translation>频响的频率必须从大于 0 处递增</translation>
    </message>
    <message>
        <source>the highest speed must lie above the lowest, both above 0</source>
        <translation>最高转速必须高于最低转速，且均大于 0</translation>
    </message>
    <message>
        <source>the largest depth must lie above 0</source>
        <translation>最大切深必须大于 0</translation>
    </message>
    <message>
        <source>the last %1 cuts do not fit the %2 before: another tool, holder or clamping? The lobes were started anew</source>
        <translation>最近 %1 次切削与之前的 %2 次不符：换了刀具、刀柄或装夹吗？稳定性图已重新开始</translation>
    </message>
    <message>
        <source>the recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>the responses have no frequencies in common</source>
        <translation>各频响没有共同的频率</translation>
    </message>
    <message>
        <source>the risk must lie between 0 and 1</source>
        <translation>风险必须在 0 与 1 之间</translation>
    </message>
    <message>
        <source>the sound output has failed: %1</source>
        <translation>声音输出失败：%1</translation>
    </message>
    <message>
        <source>the speed is not known or the sampling rate too low</source>
        <translation>转速未知或采样率过低</translation>
    </message>
    <message>
        <source>the steady cut is too short</source>
        <translation>稳定切削时间过短</translation>
    </message>
    <message>
        <source>the store of cuts cannot be opened</source>
        <translation>切削记录库无法打开</translation>
    </message>
    <message>
        <source>the store of cuts cannot be used</source>
        <translation>切削记录库无法使用</translation>
    </message>
    <message>
        <source>the sweep needs %1 mm of material</source>
        <translation>转速扫描需要 %1 mm 的材料</translation>
    </message>
    <message>
        <source>the table of materials has no &apos;%1&apos;</source>
        <translation>材料表中没有“%1”</translation>
    </message>
    <message>
        <source>there are none to keep</source>
        <translation>没有可保留的</translation>
    </message>
    <message>
        <source>there is no such channel</source>
        <translation>没有这个通道</translation>
    </message>
    <message>
        <source>there is no such channel in the file</source>
        <translation>文件中没有该通道</translation>
    </message>
    <message>
        <source>this Stillcut was built without sound output</source>
        <translation>此 Stillcut 构建时未含声音输出</translation>
    </message>
    <message>
        <source>this computer has no sound output: %1</source>
        <translation>本机没有声音输出：%1</translation>
    </message>
    <message>
        <source>this cut was quiet before: is the tool worn, or loose?</source>
        <translation>此切削以前是平稳的：刀具磨损或松动了吗？</translation>
    </message>
    <message>
        <source>this tool chattered at %1 rpm</source>
        <translation>此刀具在 %1 r/min 时颤振</translation>
    </message>
    <message>
        <source>too little is known of this tool</source>
        <translation>对此刀具了解太少</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>试切</translation>
    </message>
    <message>
        <source>update this program</source>
        <translation>请更新本程序</translation>
    </message>
    <message>
        <source>vary the spindle speed by %1 % with a period of %2 s: in simulation this quiets it</source>
        <translation>以 %2 s 的周期将主轴转速变动 %1 %：仿真中可消除颤振</translation>
    </message>
    <message>
        <source>cannot be run again</source>
        <translation>无法再次运行</translation>
    </message>
    <message>
        <source>cut.model is the file with modes and material</source>
        <translation>cut.model 是含有模态和材料的文件</translation>
    </message>
    <message>
        <source>depth of cut</source>
        <translation>切深</translation>
    </message>
    <message>
        <source>names no model of its cut</source>
        <translation>没有指明其切削的模型</translation>
    </message>
    <message>
        <source>none is entered</source>
        <translation>没有输入</translation>
    </message>
    <message>
        <source>run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>the force is not proportional to the chip: taken as it is at a chip of %1 um</source>
        <translation>切削力与切屑厚度不成正比：按切屑厚度 %1 um 处取值</translation>
    </message>
    <message>
        <source>type frequency, damping and stiffness, or open a file with modes</source>
        <translation>请输入频率、阻尼和刚度，或打开含有模态的文件</translation>
    </message>
    <message>
        <source>%1 samples a second are more than can be judged</source>
        <translation>每秒 %1 个样本，超过可判断的上限</translation>
    </message>
    <message>
        <source>a pipe is read as the standard input: - &lt; FILE</source>
        <translation>管道请作为标准输入读取：- &lt; FILE</translation>
    </message>
    <message>
        <source>a row is a time in s and a speed in rpm</source>
        <translation>每行为时间（s）和转速（r/min）</translation>
    </message>
    <message>
        <source>choose at most 32 with --channel N[,N]</source>
        <translation>用 --channel N[,N] 选择最多 32 个</translation>
    </message>
    <message>
        <source>damaged, or cut off: what records into it writes its index when it ends</source>
        <translation>损坏或被截断：其索引在录制结束时才写入</translation>
    </message>
    <message>
        <source>ends after %1 of %2 s: what is there is read</source>
        <translation>在 %2 s 中的 %1 s 处结束：已有部分照常读取</translation>
    </message>
    <message>
        <source>export each with its channels as a file of its own, or give --rate HZ</source>
        <translation>请将每个时间列及其通道分别导出为单独文件，或给出 --rate HZ</translation>
    </message>
    <message>
        <source>export those of each rate as a file of their own</source>
        <translation>请将每种采样率的通道分别导出为单独文件</translation>
    </message>
    <message>
        <source>format it as a time of day and export again, or give --rate HZ</source>
        <translation>请将其设为时刻格式后重新导出，或给出 --rate HZ</translation>
    </message>
    <message>
        <source>has %1 channels, more than are judged at once</source>
        <translation>有 %1 个通道，超过一次可判断的数量</translation>
    </message>
    <message>
        <source>has no sheet &apos;%1&apos;</source>
        <translation>没有工作表 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>it is not clear whether &apos;%1&apos; has a decimal point or thousands set apart</source>
        <translation>无法判断 &apos;%1&apos; 中是小数点还是千位分隔符</translation>
    </message>
    <message>
        <source>its channels have several rates</source>
        <translation>其通道有多种采样率</translation>
    </message>
    <message>
        <source>its coding is not known; convert it to WAV: ffmpeg -i FILE cut.wav</source>
        <translation>其编码未知；请转换为 WAV：ffmpeg -i FILE cut.wav</translation>
    </message>
    <message>
        <source>its columns have times of their own: &apos;%1&apos; goes in other steps</source>
        <translation>各列有各自的时间：&apos;%1&apos; 的步长不同</translation>
    </message>
    <message>
        <source>its header is damaged, or its coding is not known</source>
        <translation>文件头损坏，或编码未知</translation>
    </message>
    <message>
        <source>its time seems to be in days, as spreadsheets count them</source>
        <translation>其时间似乎以天为单位，如电子表格的计法</translation>
    </message>
    <message>
        <source>no sample of it can be decoded</source>
        <translation>没有任何样本可以解码</translation>
    </message>
    <message>
        <source>none of its sheets holds rows of numbers: %1</source>
        <translation>各工作表均不含数字行：%1</translation>
    </message>
    <message>
        <source>nothing in it is known as sound</source>
        <translation>其中没有可识别的声音</translation>
    </message>
    <message>
        <source>of its %1 sheets &apos;%2&apos; is read; FILE:/NAME reads another</source>
        <translation>共 %1 个工作表，读取的是 &apos;%2&apos;；用 FILE:/NAME 读取其他表</translation>
    </message>
    <message>
        <source>only HDF5, MATLAB, NumPy, TDMS and Excel files have places inside</source>
        <translation>只有 HDF5、MATLAB、NumPy、TDMS 和 Excel 文件内部有位置</translation>
    </message>
    <message>
        <source>the header promises %1 bytes, the file holds %2, which are read: its recorder did not end it</source>
        <translation>文件头声明有 %1 字节，文件实际含 %2 字节，已读取：录制程序没有正常结束该文件</translation>
    </message>
    <message>
        <source>write 0 in its place, or read the other channels with --channel N</source>
        <translation>在该处写入 0，或用 --channel N 读取其他通道</translation>
    </message>
    <message>
        <source>write NaN on every channel where samples are missing, or leave this one out</source>
        <translation>缺失样本处请在所有通道写 NaN，或略去该通道</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has more than two dimensions</source>
        <translation>“%1”超过两个维度</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a table of records, which is not read</source>
        <translation>“%1”是记录表，不能读取</translation>
    </message>
    <message>
        <source>a shorter way to the machine, or registers that lie side by side</source>
        <translation>缩短到机床的连接，或使用相邻的寄存器</translation>
    </message>
    <message>
        <source>an answer takes %1 ms, and %2 of them tell all: it is too old by then</source>
        <translation>一次应答需 %1 毫秒，%2 次应答才能读完：届时数据已过旧</translation>
    </message>
    <message>
        <source>are the unit, the register map and its answer_ms right?</source>
        <translation>单元号、寄存器表及其 answer_ms 是否正确？</translation>
    </message>
    <message>
        <source>from %1 rpm on it is possible</source>
        <translation>从 %1 rpm 起可行</translation>
    </message>
    <message>
        <source>holds &apos;%1&apos;, a cell array or an array of structs, which is not read</source>
        <translation>包含“%1”，它是元胞数组或结构体数组，不能读取</translation>
    </message>
    <message>
        <source>in line %1, &apos;%2&apos;, &apos;%3&apos; is no number; is this a recording?</source>
        <translation>第 %1 行“%2”中，“%3”不是数字；这是录音文件吗？</translation>
    </message>
    <message>
        <source>is a MATLAB file of version 4, which is not read</source>
        <translation>是第 4 版 MATLAB 文件，不能读取</translation>
    </message>
    <message>
        <source>is a table of text, whatever its name says</source>
        <translation>是文本表格，无论其名称如何</translation>
    </message>
    <message>
        <source>it counts the rows</source>
        <translation>它是行号</translation>
    </message>
    <message>
        <source>it has %1 numbers where the recording has %2</source>
        <translation>它有 %1 个数，而录音有 %2 个</translation>
    </message>
    <message>
        <source>it has no unit, where other columns have one</source>
        <translation>它没有单位，而其他列有</translation>
    </message>
    <message>
        <source>it holds no row of numbers that is read</source>
        <translation>它不包含可读取的数列</translation>
    </message>
    <message>
        <source>it holds times</source>
        <translation>它包含时间</translation>
    </message>
    <message>
        <source>it holds words</source>
        <translation>它包含文字</translation>
    </message>
    <message>
        <source>it is a speed of the spindle</source>
        <translation>它是主轴转速</translation>
    </message>
    <message>
        <source>it is mains hum of %1 Hz and little else, look at its shield and ground</source>
        <translation>其中几乎只有 %1 Hz 的工频干扰，请检查屏蔽和接地</translation>
    </message>
    <message>
        <source>it is not clear whether the rate &apos;%1&apos; of its header is a fraction or has thousands set apart</source>
        <translation>文件头中的采样率“%1”是小数还是带千位分隔符，不清楚</translation>
    </message>
    <message>
        <source>its data sets have several rates</source>
        <translation>其数据集有多个采样率</translation>
    </message>
    <message>
        <source>its name or its unit says that it is no vibration</source>
        <translation>其名称或单位表明它不是振动</translation>
    </message>
    <message>
        <source>its name says that it is no vibration</source>
        <translation>其名称表明它不是振动</translation>
    </message>
    <message>
        <source>its times &apos;%1&apos; have no unit: seconds are assumed</source>
        <translation>时间“%1”没有单位：假定为秒</translation>
    </message>
    <message>
        <source>its times are too coarse for its rows, several of which share one: they are taken as evenly spaced by the rate of its header, %1 Hz</source>
        <translation>时间对各行来说太粗，多行共用一个时间：按文件头的采样率 %1 Hz 视为等间隔</translation>
    </message>
    <message>
        <source>its times have no unit: seconds are assumed</source>
        <translation>时间没有单位：假定为秒</translation>
    </message>
    <message>
        <source>its unit &apos;%1&apos; is none of a vibration</source>
        <translation>其单位“%1”不是振动的单位</translation>
    </message>
    <message>
        <source>most of its cells hold no number</source>
        <translation>其大多数单元格没有数字</translation>
    </message>
    <message>
        <source>name one of them: %1</source>
        <translation>请指定其中一个：%1</translation>
    </message>
    <message>
        <source>save each of its columns as a data set of its own</source>
        <translation>把它的每一列存为单独的数据集</translation>
    </message>
    <message>
        <source>save it in MATLAB with -v7: save cut.mat -v7</source>
        <translation>在 MATLAB 中用 -v7 保存：save cut.mat -v7</translation>
    </message>
    <message>
        <source>save its numbers as plain variables in MATLAB: x = c{1}; save cut.mat x fs</source>
        <translation>在 MATLAB 中把数字存为普通变量：x = c{1}; save cut.mat x fs</translation>
    </message>
    <message>
        <source>save samples by channels, one block behind the other</source>
        <translation>按“样本×通道”保存，各块依次相接</translation>
    </message>
    <message>
        <source>%1 rpm is too low for teeth that differ or have a shape</source>
        <translation>对于各不相同或有成形刃的齿，%1 rpm 太低</translation>
    </message>
    <message>
        <source>a direction is three numbers: along the feed, into the part, along the cutting speed</source>
        <translation>方向是三个数：沿进给、指向工件、沿切削速度</translation>
    </message>
    <message>
        <source>a direction is two or three numbers, along x, y and z</source>
        <translation>方向是两个或三个数，沿 x、y 和 z</translation>
    </message>
    <message>
        <source>a turning cut has no tool that turns: [turning] says it all</source>
        <translation>车削中刀具不转动：[turning] 已说明一切</translation>
    </message>
    <message>
        <source>at least one speed is needed</source>
        <translation>至少需要一个转速</translation>
    </message>
    <message>
        <source>edges that stand have no pitch, helix or runout</source>
        <translation>不转动的切削刃没有齿距、螺旋角和跳动</translation>
    </message>
    <message>
        <source>give the feed per tooth</source>
        <translation>请给出每齿进给</translation>
    </message>
    <message>
        <source>is a turning cut, and this page enters milling cuts</source>
        <translation>是车削，而本页输入的是铣削</translation>
    </message>
    <message>
        <source>lobes and advice do</source>
        <translation>稳定性叶瓣图和建议支持</translation>
    </message>
    <message>
        <source>no mode moves the edge across the cut or along the cutting speed</source>
        <translation>没有任何模态使切削刃沿切屑厚度方向或切削速度方向运动</translation>
    </message>
    <message>
        <source>no mode moves the tool along x or y</source>
        <translation>没有任何模态使刀具沿 x 或 y 运动</translation>
    </message>
    <message>
        <source>one number for each of the speeds is needed</source>
        <translation>每个转速都需要一个数</translation>
    </message>
    <message>
        <source>semi-discretization takes no corner radius and no serration</source>
        <translation>半离散法不支持圆角半径和波形刃</translation>
    </message>
    <message>
        <source>speeds below %1 rpm are unknown: for teeth that differ or have a shape the exact method does not reach lower</source>
        <translation>低于 %1 rpm 的转速未知：对于各不相同或有成形刃的齿，精确方法达不到更低</translation>
    </message>
    <message>
        <source>stillcut-cli lobes takes it</source>
        <translation>stillcut-cli lobes 支持它</translation>
    </message>
    <message>
        <source>the corner radius must lie between 0 and half the diameter</source>
        <translation>圆角半径须在 0 和直径的一半之间</translation>
    </message>
    <message>
        <source>the edge&apos;s angle to the feed must lie in 5 to 150 degrees</source>
        <translation>切削刃与进给方向的夹角须在 5 到 150 度之间</translation>
    </message>
    <message>
        <source>the serration needs one phase per tooth</source>
        <translation>波形刃需要每齿一个相位</translation>
    </message>
    <message>
        <source>the serration&apos;s amplitude must be above zero and below a quarter of the diameter</source>
        <translation>波形刃的振幅须大于零且小于直径的四分之一</translation>
    </message>
    <message>
        <source>the serration&apos;s phases must be finite</source>
        <translation>波形刃的相位须为有限值</translation>
    </message>
    <message>
        <source>the serration&apos;s wave length must be above zero</source>
        <translation>波形刃的波长须大于零</translation>
    </message>
    <message>
        <source>the simulation takes no corner radius and no serration</source>
        <translation>仿真不支持圆角半径和波形刃</translation>
    </message>
    <message>
        <source>the speeds of a mode must rise from 0 or more</source>
        <translation>一个模态的各转速须从 0 或更大的值起依次递增</translation>
    </message>
    <message>
        <source>the zeroth order takes no corner radius and no serration</source>
        <translation>零阶方法不支持圆角半径和波形刃</translation>
    </message>
    <message>
        <source>what one edge feels across, the edge opposite feels the other way</source>
        <translation>一个切削刃受到的横向作用，在对面的切削刃上正好相反</translation>
    </message>
    <message>
        <source>which teeth of a serrated tool cut depends on the feed</source>
        <translation>波形刃刀具的哪些齿在切削取决于进给</translation>
    </message>
    <message>
        <source>with several edges the modes may move along the feed and the cutting speed only</source>
        <translation>有多个切削刃时，模态只能沿进给方向和切削速度方向运动</translation>
    </message>
    <message>
        <source>&apos;stillcut-cli modal&apos; and the page Tap test read it</source>
        <translation>请用“stillcut-cli modal”或“敲击”页读取</translation>
    </message>
    <message>
        <source>a coherence</source>
        <translation>相干函数</translation>
    </message>
    <message>
        <source>a frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>a function of type %1</source>
        <translation>类型为 %1 的函数</translation>
    </message>
    <message>
        <source>a spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>another Stillcut could not be told from none</source>
        <translation>无法区分是否有另一个 Stillcut</translation>
    </message>
    <message>
        <source>at least 100 are needed; is its time not in seconds? --time-unit or --rate says so</source>
        <translation>至少需要 100；其时间不是以秒计？请用 --time-unit 或 --rate 指明</translation>
    </message>
    <message>
        <source>at most 1000000; is its time not in seconds? --time-unit or --rate says so</source>
        <translation>最多 1000000；其时间不是以秒计？请用 --time-unit 或 --rate 指明</translation>
    </message>
    <message>
        <source>export the samples over time that it was made of</source>
        <translation>请导出生成它的时间采样数据</translation>
    </message>
    <message>
        <source>holds a time stamp that makes no sense</source>
        <translation>含有无意义的时间戳</translation>
    </message>
    <message>
        <source>is a spectrum and no recording: &apos;%1&apos; holds frequencies</source>
        <translation>是频谱而不是记录：“%1”中是频率</translation>
    </message>
    <message>
        <source>is no recording: it holds %1</source>
        <translation>不是记录：其中是%1</translation>
    </message>
    <message>
        <source>is read without [write.heartbeat]</source>
        <translation>在没有 [write.heartbeat] 的情况下读取</translation>
    </message>
    <message>
        <source>it has another rate or length</source>
        <translation>其采样率或长度不同</translation>
    </message>
    <message>
        <source>it holds %1</source>
        <translation>其中是%1</translation>
    </message>
    <message>
        <source>its time has no unit; its steps of %1 would be %2 Hz in seconds</source>
        <translation>其时间没有单位；步长 %1 若以秒计则为 %2 Hz</translation>
    </message>
    <message>
        <source>open the samples that it was made of; a frequency response goes into the tap test</source>
        <translation>请打开生成它的采样数据；频率响应请用“敲击”页</translation>
    </message>
    <message>
        <source>say --time-unit %1, or s if it is that slow</source>
        <translation>用 --time-unit 指明 %1；若确实这么慢则为 s</translation>
    </message>
    <message>
        <source>say --time-unit s, ms, us or ns, or give --rate HZ</source>
        <translation>用 --time-unit 指明 s、ms、us 或 ns，或给出 --rate HZ</translation>
    </message>
    <message>
        <source>two responses and no word of the force: right only if x and y were each hit along themselves</source>
        <translation>有两个响应而未说明力的方向：仅当 x 和 y 各沿自身方向敲击时才正确</translation>
    </message>
</context>
<context>
    <name>Learned</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Next most useful cut: %1, because it tells most (stable with %2).</source>
        <translation>下一刀最有用：%1，因为信息最多（稳定概率 %2）。</translation>
    </message>
    <message>
        <source>Next most useful cut: %1, because its outcome (stable with %2) may raise the removal rate most: %3 expected.</source>
        <translation>下一刀最有用：%1，其结果（稳定概率 %2）最可能提高去除率：预期 %3。</translation>
    </message>
    <message>
        <source>Nothing is learned from these cuts: say machine, tool, teeth, depth and modes under Set up.</source>
        <translation>无法从这些切削中学习：请在“设置”中填写机床、刀具、齿数、切深和模态。</translation>
    </message>
    <message>
        <source>Learned from cuts: nothing yet. Cut with this tool: every judged cut is kept and counts here.</source>
        <translation>从切削中学到：暂无。用这把刀切削：每次判定过的切削都会保存并计入。</translation>
    </message>
    <message>
        <source>Learned from cuts: %1</source>
        <translation>从切削中学到：%1</translation>
    </message>
    <message>
        <source>Learned from %1 judged cuts (%2 with chatter) and the tool&apos;s modes.</source>
        <translation>由 %1 次判定过的切削（%2 次颤振）和刀具模态学得。</translation>
    </message>
    <message>
        <source>%1 older ones are set aside: the newest indicate another tool.</source>
        <translation>%1 次较早的不再计入：最新的表明是另一把刀。</translation>
    </message>
    <message>
        <source>Recommended at a risk of %1: %2.</source>
        <translation>在 %1 的风险下推荐：%2。</translation>
    </message>
    <message>
        <source>Learned from cuts: stable here with %1</source>
        <translation>从切削中学到：此处稳定概率 %1</translation>
    </message>
    <message>
        <source>Judged cut: stable</source>
        <translation>判定过的切削：稳定</translation>
    </message>
    <message>
        <source>Judged cut: chatter, %1</source>
        <translation>判定过的切削：颤振，%1</translation>
    </message>
    <message>
        <source>Judged cut: chatter</source>
        <translation>判定过的切削：颤振</translation>
    </message>
    <message>
        <source>No deeper: this cut is close to its limit</source>
        <translation>不要再加深：本次切削已接近极限</translation>
    </message>
    <message>
        <source>Depth could rise by about %1 (%2 to %3)</source>
        <translation>切深还可增加约 %1（%2 至 %3）</translation>
    </message>
</context>
<context>
    <name>LobeMarks</name>
    <message>
        <source>now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>advised</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>what if</source>
        <translation>假设</translation>
    </message>
    <message>
        <source>was stable</source>
        <translation>曾稳定</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>颤振</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>叶瓣图</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>调整</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Tap test</source>
        <translation>敲击</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
</context>
<context>
    <name>PlotFrame</name>
    <message>
        <source>time [s]</source>
        <translation>时间 [s]</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>Spectrogram of %1 [kHz]</source>
        <translation>%1 的频谱图 [kHz]</translation>
    </message>
    <message>
        <source>Vibration of %1, rms [%2]</source>
        <translation>%1 的振动有效值 [%2]</translation>
    </message>
    <message>
        <source>Energy ratio, chatter to all</source>
        <translation>能量比，颤振占总量</translation>
    </message>
    <message>
        <source>Spindle speed [rpm]</source>
        <translation>主轴转速 [rpm]</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>Auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Advise</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>the spindle speed is not known</source>
        <translation>主轴转速未知</translation>
    </message>
    <message>
        <source>samples are missing ({0.0} counted)</source>
        <translation>缺少采样（计得 {0.0} 个）</translation>
    </message>
    <message>
        <source>the sensor is at its limit</source>
        <translation>传感器已达量程极限</translation>
    </message>
    <message>
        <source>channel {0.0} delivers values that are not numbers</source>
        <translation>通道 {0.0} 给出的不是数值</translation>
    </message>
    <message>
        <source>channel {0.0} delivers a constant</source>
        <translation>通道 {0.0} 输出恒定值</translation>
    </message>
    <message>
        <source>the spindle is running up, {0.0} rpm</source>
        <translation>主轴正在加速，{0.0} rpm</translation>
    </message>
    <message>
        <source>the tool is entering or leaving</source>
        <translation>刀具正在切入或切出</translation>
    </message>
    <message>
        <source>energy ratio {0.2} is over {1.2}</source>
        <translation>能量比 {0.2} 超过 {1.2}</translation>
    </message>
    <message>
        <source>energy ratio {0.3} grows above its floor of {1.3}</source>
        <translation>能量比 {0.3} 高于本底 {1.3} 并在增长</translation>
    </message>
    <message>
        <source>a line at {2.1} Hz between the harmonics holds {0.3} of the vibration, over {1.3}</source>
        <translation>谐波之间 {2.1} Hz 的谱线占振动的 {0.3}，超过 {1.3}</translation>
    </message>
    <message>
        <source>vibration that the harmonics leave, {0.3} of all, is over {1.3}, strongest at {2.1} Hz</source>
        <translation>除去谐波后的振动占 {0.3}，超过 {1.3}，在 {2.1} Hz 最强</translation>
    </message>
    <message>
        <source>coherence ratio {0.2} is over {1.2} at {2.1} Hz and its energy grows</source>
        <translation>{2.1} Hz 处相干比 {0.2} 超过 {1.2}，且能量增长</translation>
    </message>
    <message>
        <source>coherence needs two channels, there are {0.0}</source>
        <translation>相干检测需要两个通道，现有 {0.0} 个</translation>
    </message>
    <message>
        <source>detector {0.0} failed</source>
        <translation>检测器 {0.0} 失效</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>无需操作</translation>
    </message>
    <message>
        <source>{0.0} rpm puts {1.0} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</source>
        <translation>{0.0} rpm 使两齿之间恰有 {1.0} 个 {2.0} Hz 颤振波，原为 {3.0} rpm</translation>
    </message>
    <message>
        <source>feed follows to {0.0} mm/min, so that each tooth still takes {1.3} mm</source>
        <translation>进给随之变为 {0.0} mm/min，使每齿仍切 {1.3} mm</translation>
    </message>
    <message>
        <source>monitoring only</source>
        <translation>仅监测</translation>
    </message>
    <message>
        <source>there is no usable verdict to act on</source>
        <translation>没有可用的结论作为依据</translation>
    </message>
    <message>
        <source>going back towards {0.2}</source>
        <translation>正在恢复到 {0.2}</translation>
    </message>
    <message>
        <source>{0.0} rpm is already the speed for chatter at {1.0} Hz</source>
        <translation>{0.0} rpm 已是针对 {1.0} Hz 颤振的转速</translation>
    </message>
    <message>
        <source>{0.0} rpm with {1.0} waves between two teeth is in reach, {2.0} rpm is not (chatter {3.0} Hz)</source>
        <translation>两齿间 {1.0} 个波的 {0.0} rpm 可达，{2.0} rpm 不可达（颤振 {3.0} Hz）</translation>
    </message>
    <message>
        <source>{0.0} rpm puts {1.2} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</source>
        <translation>{0.0} rpm 使两齿之间有 {1.2} 个 {2.0} Hz 颤振波，原为 {3.0} rpm</translation>
    </message>
    <message>
        <source>{0.0} rpm brings a tooth harmonic closer to the chatter, {1.1} Hz apart, level {2.2} of its mean</source>
        <translation>{0.0} rpm 使齿通谐波更接近颤振，相差 {1.1} Hz，水平为均值的 {2.2}</translation>
    </message>
    <message>
        <source>trying {0.0} rpm for less vibration, now {1.4}, best so far {2.4} at {3.0} rpm</source>
        <translation>正在尝试 {0.0} rpm 以减小振动，现为 {1.4}，迄今最好 {2.4}({3.0} rpm)</translation>
    </message>
    <message>
        <source>{0.0} rpm vibrates least, {1.4}</source>
        <translation>{0.0} rpm 振动最小，{1.4}</translation>
    </message>
    <message>
        <source>{0.0} rpm lies between the stability limits at {1.0} and {2.0} rpm (chatter {3.0} Hz)</source>
        <translation>{0.0} rpm 位于 {1.0} 与 {2.0} rpm 的稳定极限之间（颤振 {3.0} Hz）</translation>
    </message>
    <message>
        <source>no speed in reach is stable at this depth, {1.2} mm at {2.0} rpm would be (chatter {3.0} Hz)</source>
        <translation>此切深下没有可达的稳定转速，{2.0} rpm 时 {1.2} mm 可稳定（颤振 {3.0} Hz）</translation>
    </message>
    <message>
        <source>coherence {0.2} and energy {1.1} times that of the stable cut ask for {2.0} rpm and {3.0} mm/min</source>
        <translation>相干 {0.2} 与稳定切削 {1.1} 倍的能量要求 {2.0} rpm 和 {3.0} mm/min</translation>
    </message>
    <message>
        <source>authority is off</source>
        <translation>权限已关闭</translation>
    </message>
    <message>
        <source>advice only</source>
        <translation>仅建议</translation>
    </message>
    <message>
        <source>the request was not a number</source>
        <translation>请求不是数值</translation>
    </message>
    <message>
        <source>asked for {0.0} %, the limits allow {1.0} %</source>
        <translation>请求 {0.0} %，限值允许 {1.0} %</translation>
    </message>
    <message>
        <source>the machine&apos;s state is {0.2} s old</source>
        <translation>机床状态已过去 {0.2} s</translation>
    </message>
    <message>
        <source>the verdict is {0.2} s old</source>
        <translation>结论已过去 {0.2} s</translation>
    </message>
    <message>
        <source>the machine is not running a program</source>
        <translation>机床没有运行程序</translation>
    </message>
    <message>
        <source>held by the operator</source>
        <translation>由操作者保持</translation>
    </message>
    <message>
        <source>waiting for the spindle, {0.0} of {1.0} rpm</source>
        <translation>等待主轴，{0.0} / {1.0} rpm</translation>
    </message>
    <message>
        <source>{0.0} changes in a minute, {1.0} allowed</source>
        <translation>一分钟内 {0.0} 次变化，允许 {1.0} 次</translation>
    </message>
    <message>
        <source>the programmed values are back in force</source>
        <translation>编程值已重新生效</translation>
    </message>
    <message>
        <source>no fresh command for {0.2} s, programmed values restored</source>
        <translation>{0.2} s 没有新指令，已恢复编程值</translation>
    </message>
    <message>
        <source>speed {0.1} % and feed {1.1} %, with the knobs {2.1} % and {3.1} %</source>
        <translation>转速 {0.1} %、进给 {1.1} %，连同旋钮 {2.1} % 与 {3.1} %</translation>
    </message>
    <message>
        <source>speed {0.1} % on its way to {1.1} %, feed {2.1} % to {3.1} %</source>
        <translation>转速由 {0.1} % 变向 {1.1} %，进给由 {2.1} % 变向 {3.1} %</translation>
    </message>
    <message>
        <source>what the machine reports makes no sense</source>
        <translation>机床报告的数据不合理</translation>
    </message>
    <message>
        <source>the overrides have no effect: locked by the program, or at the machine&apos;s limit</source>
        <translation>倍率不起作用：被程序锁定，或机床已到极限</translation>
    </message>
    <message>
        <source>something else controls the overrides</source>
        <translation>倍率由其他程序控制</translation>
    </message>
    <message>
        <source>the detector&apos;s verdict is not usable</source>
        <translation>检测器的结论不可用</translation>
    </message>
    <message>
        <source>the request is {0.2} s old</source>
        <translation>请求已过去 {0.2} s</translation>
    </message>
    <message>
        <source>time stood still, jumped or went back</source>
        <translation>时间停滞、跳变或倒退</translation>
    </message>
    <message>
        <source>the tool is not in the cut</source>
        <translation>刀具未在切削</translation>
    </message>
    <message>
        <source>the feed is on hold</source>
        <translation>进给保持中</translation>
    </message>
    <message>
        <source>the operator turns the knobs: speed {0.0} %, feed {1.0} %</source>
        <translation>操作者正在调旋钮：转速 {0.0} %，进给 {1.0} %</translation>
    </message>
    <message>
        <source>the spindle does not follow, {0.0} instead of {1.0} rpm</source>
        <translation>主轴未跟随，{0.0} 而非 {1.0} rpm</translation>
    </message>
    <message>
        <source>the machine does not take the override, {0.1} % instead of {1.1} %</source>
        <translation>机床未接受倍率，{0.1} % 而非 {1.1} %</translation>
    </message>
    <message>
        <source>the program went from {0.0} to {1.0} rpm, starting again from 100 %</source>
        <translation>程序由 {0.0} 变为 {1.0} rpm，重新从 100 % 开始</translation>
    </message>
    <message>
        <source>waiting {0.1} s before taking the overrides again</source>
        <translation>等待 {0.1} s 后再接管倍率</translation>
    </message>
    <message>
        <source>too many changes, waiting {0.0} s</source>
        <translation>变化过多，等待 {0.0} s</translation>
    </message>
    <message>
        <source>Auto is not allowed in this set-up</source>
        <translation>此设置不允许自动</translation>
    </message>
    <message>
        <source>more than {0.0} changes in a minute again, advice only from now on</source>
        <translation>一分钟内变化再次超过 {0.0} 次，此后仅建议</translation>
    </message>
    <message>
        <source>the operator accepted {0.0} rpm and {1.0} mm/min</source>
        <translation>操作者接受 {0.0} rpm 和 {1.0} mm/min</translation>
    </message>
    <message>
        <source>the operator refused {0.0} rpm and {1.0} mm/min</source>
        <translation>操作者拒绝 {0.0} rpm 和 {1.0} mm/min</translation>
    </message>
    <message>
        <source>chatter at {0.0} Hz, energy ratio {1.2}</source>
        <translation>{0.0} Hz 颤振，能量比 {1.2}</translation>
    </message>
    <message>
        <source>authority changed from {0.0} to {1.0}</source>
        <translation>权限由 {0.0} 变为 {1.0}</translation>
    </message>
    <message>
        <source>back to 100 % at the operator&apos;s request</source>
        <translation>应操作者要求恢复 100 %</translation>
    </message>
    <message>
        <source>the machine has not answered for {0.2} s</source>
        <translation>机床已 {0.2} s 未应答</translation>
    </message>
    <message>
        <source>the machine answers again</source>
        <translation>机床恢复应答</translation>
    </message>
    <message>
        <source>recording has stopped</source>
        <translation>记录已停止</translation>
    </message>
    <message>
        <source>{0.0} blocks were dropped</source>
        <translation>丢失 {0.0} 个数据块</translation>
    </message>
    <message>
        <source>Auto is granted because this machine is simulated</source>
        <translation>因为是模拟机床，允许自动</translation>
    </message>
    <message>
        <source>the strategy failed, monitoring only from now on</source>
        <translation>策略失效，此后仅监测</translation>
    </message>
    <message>
        <source>the advice has changed to {0.0} rpm and {1.0} mm/min, it needs another touch</source>
        <translation>建议已变为 {0.0} rpm 和 {1.0} mm/min，需再次触按</translation>
    </message>
    <message>
        <source>the tool left the cut after {0.2} s and {1.1} mm of feed in chatter</source>
        <translation>颤振 {0.2} s、进给 {1.1} mm 后刀具离开切削</translation>
    </message>
    <message>
        <source>the machine or its program put the override back to {0.0} %, Stillcut had it at {1.0} %</source>
        <translation>机床或其程序把倍率恢复到 {0.0} %，Stillcut 此前设为 {1.0} %</translation>
    </message>
    <message>
        <source>{0.0} lines more than there was room for, the most important were kept</source>
        <translation>多出 {0.0} 行放不下，已保留最重要的</translation>
    </message>
    <message>
        <source>channel {0.0} fell silent in the middle of the cut, look for a broken cable</source>
        <translation>通道 {0.0} 在切削过程中失去信号，请检查电缆是否断裂</translation>
    </message>
    <message>
        <source>channel {0.0} knocks at any spindle angle, its sensor is loose</source>
        <translation>通道 {0.0} 在任意主轴转角出现敲击，其传感器松动</translation>
    </message>
    <message>
        <source>channel {0.0} has left its zero and stands at {1.1}, look at its supply and range</source>
        <translation>通道 {0.0} 偏离零点，停在 {1.1}，请检查其供电和量程</translation>
    </message>
    <message>
        <source>most of what channel {0.0} delivers is mains hum of {1.0} Hz, look at its shield and ground</source>
        <translation>通道 {0.0} 的信号大部分是 {1.0} Hz 工频干扰，请检查其屏蔽和接地</translation>
    </message>
    <message>
        <source>channel {0.0} delivers strong noise and no cut</source>
        <translation>通道 {0.0} 只有强噪声，没有切削信号</translation>
    </message>
    <message>
        <source>channels {0.0} and {1.0} claim two axes and deliver the same, one of them is wired or named wrongly</source>
        <translation>通道 {0.0} 和 {1.0} 标为两个轴却给出相同信号，其中一个接线或命名有误</translation>
    </message>
    <message>
        <source>the device delivers {0.1} samples a second instead of {1.1}</source>
        <translation>设备每秒给出 {0.1} 个采样，而不是 {1.1} 个</translation>
    </message>
    <message>
        <source>channel {0.0} has a line at {1.1} Hz that moves as order {2.0} folded back, its anti-alias filter is missing</source>
        <translation>通道 {0.0} 在 {1.1} Hz 处有一条谱线，其移动方式与折叠回来的第 {2.0} 阶相同，缺少抗混叠滤波器</translation>
    </message>
    <message>
        <source>still learning, {0.1} s to go</source>
        <translation>仍在学习，还需 {0.1} 秒</translation>
    </message>
    <message>
        <source>channel {0.0} repeats its values, or comes at another rate than set</source>
        <translation>通道 {0.0} 重复数值，或采样率与所给的不同</translation>
    </message>
    <message>
        <source>{0.0} rpm would help against chatter of {3.0} Hz but the override reaches {1.0} to {2.0} rpm</source>
        <translation>{0.0} rpm 可抑制 {3.0} Hz 的颤振，但倍率只能到 {1.0} 至 {2.0} rpm</translation>
    </message>
    <message>
        <source>monitoring only, at {0.0} rpm and an energy ratio of {1.2}</source>
        <translation>仅监测，{0.0} rpm，能量比 {1.2}</translation>
    </message>
    <message>
        <source>nothing to do at {0.0} rpm and an energy ratio of {1.2}</source>
        <translation>{0.0} rpm，能量比 {1.2}，无需操作</translation>
    </message>
    <message>
        <source>verdict or machine state cannot be acted on, staying at {0.0} rpm</source>
        <translation>结论或机床状态不可用，停留在 {0.0} rpm</translation>
    </message>
    <message>
        <source>a tone of {0.0} Hz fills the signal from its start, chatter or the machine itself</source>
        <translation>信号从一开始就被 {0.0} Hz 的单一音调占满，是颤振或机床本身的声音</translation>
    </message>
    <message>
        <source>the move to {0.0} rpm did not help ({1.0} in a row, {2.0} end Auto)</source>
        <translation>改到 {0.0} rpm 没有效果（连续 {1.0} 次，{2.0} 次后结束自动）</translation>
    </message>
    <message>
        <source>at {0.0} rpm the cut is {1.1} times as loud as before the move ({2.0} moves in a row without help, {3.0} end Auto)</source>
        <translation>在 {0.0} rpm 时切削振动是调整前的 {1.1} 倍（连续 {2.0} 次无效，{3.0} 次后结束自动）</translation>
    </message>
    <message>
        <source>{0.0} rpm made the cut louder and is not tried again</source>
        <translation>{0.0} rpm 使切削更响，不再尝试</translation>
    </message>
    <message>
        <source>{0.0} moves in a row did not help, advice only from now on</source>
        <translation>连续 {0.0} 次调整没有效果，从现在起只提建议</translation>
    </message>
    <message>
        <source>no chatter at {0.0} rpm, though the cut is {1.1} times as loud as before the move</source>
        <translation>在 {0.0} rpm 没有颤振，但切削振动是调整前的 {1.1} 倍</translation>
    </message>
    <message>
        <source>the newest samples that were judged are {0.2} s old, nothing is moved by them</source>
        <translation>最新判断的采样已有 {0.2} s，不据此调整</translation>
    </message>
    <message>
        <source>channel {0.0} delivers values that no sensor has</source>
        <translation>通道 {0.0} 传来任何传感器都不可能有的数值</translation>
    </message>
    <message>
        <source>the number of flutes is not known</source>
        <translation>刃数未知</translation>
    </message>
    <message>
        <source>stable, keeping {0.0} rpm that chatter of {1.0} Hz asked for</source>
        <translation>已稳定，保持因 {1.0} Hz 颤振而选的 {0.0} rpm</translation>
    </message>
    <message>
        <source>{0.0} speeds tried and none is stable (chatter {1.0} Hz): take less depth than where it began, {2.0} mm of feed before</source>
        <translation>已试 {0.0} 个转速均不稳定（颤振 {1.0} Hz）：切深须小于颤振开始处，即 {2.0} mm 进给之前</translation>
    </message>
    <message>
        <source>stable again after {0.2} s and {1.1} mm of feed</source>
        <translation>{0.2} s、进给 {1.1} mm 后恢复稳定</translation>
    </message>
    <message>
        <source>the number of flutes is not known, no speed follows from chatter of {0.0} Hz at {1.0} rpm</source>
        <translation>刃数未知，无法由 {1.0} rpm 时 {0.0} Hz 的颤振得出转速</translation>
    </message>
    <message>
        <source>nothing was read from a machine yet</source>
        <translation>尚未从机床读到任何数据</translation>
    </message>
    <message>
        <source>the tone of an axis drive glides, now at {0.0} Hz</source>
        <translation>轴驱动的音调正在滑动，现为 {0.0} Hz</translation>
    </message>
</context>
<context>
    <name>ReportPages</name>
    <message>
        <source>Cut report</source>
        <translation>切削报告</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>Alarms and what was done</source>
        <translation>报警与处理</translation>
    </message>
    <message>
        <source>Before: highest until the first command. After: newest at the end of the alarm. Numbers are those in the plots.</source>
        <translation>之前：首个指令前的最大值。之后：报警结束时的最新值。编号与图中一致。</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>另有 %1 项</translation>
    </message>
    <message>
        <source>Sensor check</source>
        <translation>传感器检查</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Settings changed during the cut</source>
        <translation>切削中更改的设置</translation>
    </message>
    <message>
        <source>Settings at the beginning</source>
        <translation>开始时的设置</translation>
    </message>
</context>
<context>
    <name>Session</name>
    <message>
        <source>The device is gone; identify again when it is back</source>
        <translation>设备已断开；恢复后请重新辨识</translation>
    </message>
    <message>
        <source>Replay: %1</source>
        <translation>回放：%1</translation>
    </message>
    <message>
        <source>The run has ended</source>
        <translation>运行已结束</translation>
    </message>
    <message>
        <source>The run of %1 did not end in order; nothing of it was recorded</source>
        <translation>%1 的运行未正常结束；没有任何记录</translation>
    </message>
    <message>
        <source>The run of %1 did not end in order; it is recorded in %2</source>
        <translation>%1 的运行未正常结束；记录在 %2</translation>
    </message>
</context>
<context>
    <name>Tap</name>
    <message>
        <source>tap test: %1 modes</source>
        <translation>敲击试验：%1 个模态</translation>
    </message>
    <message>
        <source>Simulated hammer and tool</source>
        <translation>模拟力锤和刀具</translation>
    </message>
    <message>
        <source>As chosen under Set up</source>
        <translation>如“设置”中所选</translation>
    </message>
    <message>
        <source>Say it below and touch READ.</source>
        <translation>请在下方填写并按“读取”。</translation>
    </message>
    <message>
        <source>The resonance at %1 Hz is deeper than every mode found, and too noisy to be fitted: a depth would be too large. Hit harder, average more hits, or take a harder tip.</source>
        <translation>%1 Hz 处的共振比找到的每个模态都更深，且噪声太大无法拟合：给出的切深会过大。请用力敲击、增加敲击次数或换用更硬的锤头。</translation>
    </message>
</context>
<context>
    <name>Trial</name>
    <message>
        <source>%1 Hz, channels: %2</source>
        <translation>%1 Hz，通道数：%2</translation>
    </message>
    <message>
        <source>%1: a tone of %2 Hz, %3 % of what is heard; scale %4 ± %5 %6</source>
        <translation>%1：%2 Hz 纯音，占所测信号的 %3 %；比例 %4 ± %5 %6</translation>
    </message>
</context>
<context>
    <name>stillcut::ui</name>
    <message>
        <source>%1 rpm, %2</source>
        <translation>%1 rpm，%2</translation>
    </message>
    <message>
        <source>Costs no time</source>
        <translation>不增加时间</translation>
    </message>
    <message>
        <source>Costs %1 time</source>
        <translation>时间增加 %1</translation>
    </message>
    <message>
        <source>Saves %1 time</source>
        <translation>时间节省 %1</translation>
    </message>
    <message>
        <source>cutting speed %1</source>
        <translation>切削速度 %1</translation>
    </message>
    <message>
        <source>The feed stays as it is</source>
        <translation>进给保持不变</translation>
    </message>
    <message>
        <source>Feed follows: %1</source>
        <translation>进给随动：%1</translation>
    </message>
    <message>
        <source>The speed stays as it is</source>
        <translation>转速保持不变</translation>
    </message>
    <message>
        <source>ADVICE</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Back to 100 %</source>
        <translation>恢复 100 %</translation>
    </message>
    <message>
        <source>ASKED FOR, NOT CONFIRMED BY THE MACHINE</source>
        <translation>已请求，机床未确认</translation>
    </message>
    <message>
        <source>WHAT TO DO</source>
        <translation>操作建议</translation>
    </message>
    <message>
        <source>No advice</source>
        <translation>没有建议</translation>
    </message>
    <message>
        <source>There is no live picture to advise on</source>
        <translation>没有实时画面可供建议</translation>
    </message>
    <message>
        <source>Nothing to do</source>
        <translation>无需操作</translation>
    </message>
    <message>
        <source>Authority is off: Stillcut only watches</source>
        <translation>权限已关闭：Stillcut 仅观察</translation>
    </message>
    <message>
        <source>There is no verdict to act on</source>
        <translation>没有结论作为依据</translation>
    </message>
    <message>
        <source>The strategy has not decided yet</source>
        <translation>策略尚未决定</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>约 %1</translation>
    </message>
    <message>
        <source>The machine does not answer; last values %1 old</source>
        <translation>机床无应答；最近数值已过 %1</translation>
    </message>
    <message>
        <source>Values are %1 old</source>
        <translation>数值已过 %1</translation>
    </message>
    <message>
        <source>Another program has the overrides</source>
        <translation>倍率由其他程序占用</translation>
    </message>
    <message>
        <source>The program has switched overrides off</source>
        <translation>程序已关闭倍率</translation>
    </message>
    <message>
        <source>Feed hold</source>
        <translation>进给保持</translation>
    </message>
    <message>
        <source>Energy ratio</source>
        <translation>能量比</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>振动</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>相干性</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>Nothing was read from the machine yet</source>
        <translation>尚未从机床读取数据</translation>
    </message>
    <message>
        <source>Knobs %1, %2</source>
        <translation>旋钮 %1，%2</translation>
    </message>
    <message>
        <source>Knobs %1, %2; feed per tooth %3</source>
        <translation>旋钮 %1，%2；每齿进给 %3</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>no answer for %1</source>
        <translation>无应答 %1</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>no samples yet</source>
        <translation>尚无采样</translation>
    </message>
    <message>
        <source>nothing for %1</source>
        <translation>%1 无数据</translation>
    </message>
    <message>
        <source>at its limit</source>
        <translation>达到极限</translation>
    </message>
    <message>
        <source>dead</source>
        <translation>无信号</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>非数值</translation>
    </message>
    <message>
        <source>samples missing</source>
        <translation>采样缺失</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1, %2 lost</source>
        <translation>%1，丢失 %2</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Chatter %1</source>
        <translation>颤振 %1</translation>
    </message>
    <message>
        <source>%1, acting</source>
        <translation>%1，处理中</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>颤振 %1</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>采样率</translation>
    </message>
    <message>
        <source>You are in command</source>
        <translation>由您控制</translation>
    </message>
    <message>
        <source>Stillcut is in command</source>
        <translation>由 Stillcut 控制</translation>
    </message>
    <message>
        <source>You are in command, Stillcut advises</source>
        <translation>由您控制，Stillcut 建议</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>自 %1</translation>
    </message>
    <message>
        <source>%1, on this simulated machine</source>
        <translation>%1，在此模拟机床上</translation>
    </message>
    <message>
        <source>as last heard, %1 ago</source>
        <translation>最近消息，%1 前</translation>
    </message>
    <message>
        <source>held by you, %1</source>
        <translation>由您保持，%1</translation>
    </message>
    <message>
        <source>NO CUT</source>
        <translation>空走</translation>
    </message>
    <message>
        <source>STABLE</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>ONSET</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>CHATTER</source>
        <translation>颤振</translation>
    </message>
    <message>
        <source>period doubling</source>
        <translation>倍周期</translation>
    </message>
    <message>
        <source>forced vibration</source>
        <translation>强迫振动</translation>
    </message>
    <message>
        <source>growing</source>
        <translation>增长中</translation>
    </message>
    <message>
        <source>steady</source>
        <translation>平稳持续</translation>
    </message>
    <message>
        <source>dying down</source>
        <translation>衰减中</translation>
    </message>
    <message>
        <source>The tool is in the air</source>
        <translation>刀具在空切</translation>
    </message>
    <message>
        <source>The spindle is running up</source>
        <translation>主轴正在加速</translation>
    </message>
    <message>
        <source>The tool is entering</source>
        <translation>刀具正在切入</translation>
    </message>
    <message>
        <source>The tool is leaving</source>
        <translation>刀具正在切出</translation>
    </message>
    <message>
        <source>No chatter in this run</source>
        <translation>本次运行无颤振</translation>
    </message>
    <message>
        <source>In chatter so far: %1, %2</source>
        <translation>累计颤振：%1，%2</translation>
    </message>
    <message>
        <source>ENTRY</source>
        <translation>切入</translation>
    </message>
    <message>
        <source>EXIT</source>
        <translation>切出</translation>
    </message>
    <message>
        <source>NO VERDICT</source>
        <translation>无结论</translation>
    </message>
    <message>
        <source>The picture is stale: nothing new for %1</source>
        <translation>画面已过时：%1 无新数据</translation>
    </message>
    <message>
        <source>Last verdict: %1 %2</source>
        <translation>最近结论：%1 %2</translation>
    </message>
    <message>
        <source>For %1</source>
        <translation>已持续 %1</translation>
    </message>
    <message>
        <source>For %1, %2 of feed</source>
        <translation>已持续 %1，进给 %2</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>等待首批采样</translation>
    </message>
    <message>
        <source>The run has ended</source>
        <translation>运行已结束</translation>
    </message>
    <message>
        <source>The detector gives no reason</source>
        <translation>检测器未说明原因</translation>
    </message>
    <message>
        <source>Early warning: vibration begins to grow</source>
        <translation>预警：振动开始增长</translation>
    </message>
    <message>
        <source>The tool does not cut</source>
        <translation>刀具未切削</translation>
    </message>
    <message>
        <source>Auto: Stillcut commanded the overrides</source>
        <translation>自动：Stillcut 控制倍率</translation>
    </message>
    <message>
        <source>Advise: Stillcut proposed</source>
        <translation>建议：Stillcut 提出建议</translation>
    </message>
    <message>
        <source>Off: Stillcut watched</source>
        <translation>关闭：Stillcut 仅观察</translation>
    </message>
    <message>
        <source>no signal: check cable and supply</source>
        <translation>无信号：检查电缆与供电</translation>
    </message>
    <message>
        <source>clipped: lower the gain</source>
        <translation>削波：降低增益</translation>
    </message>
    <message>
        <source>large constant part: check coupling</source>
        <translation>直流分量大：检查耦合</translation>
    </message>
    <message>
        <source>far weaker than the others: loose?</source>
        <translation>远弱于其他通道：松动？</translation>
    </message>
    <message>
        <source>in order</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>cut ended</source>
        <translation>切削结束</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>未应答</translation>
    </message>
    <message>
        <source> (simulated)</source>
        <translation>（模拟）</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>, diameter </source>
        <translation>，直径 </translation>
    </message>
    <message>
        <source>Programmed</source>
        <translation>编程值</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>权限</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>%1 at %2 Hz</source>
        <translation>%1，%2 Hz</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>%1 in %2 gaps</source>
        <translation>%2 处间断共 %1</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>not closed: ends where it was cut off</source>
        <translation>未正常关闭：在中断处结束</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>记录程序</translation>
    </message>
    <message>
        <source>This recording holds measurements only: nobody decided while it was made. Vibration and spectrogram are shown as they are.</source>
        <translation>此记录仅含测量数据：记录时未做任何结论。振动与频谱图按原样显示。</translation>
    </message>
    <message>
        <source>No chatter was found.</source>
        <translation>未发现颤振。</translation>
    </message>
    <message>
        <source>Chatter began once</source>
        <translation>颤振发生一次</translation>
    </message>
    <message>
        <source>Chatter began %1 times</source>
        <translation>颤振发生 %1 次</translation>
    </message>
    <message>
        <source>, first at %1</source>
        <translation>，首次在 %1</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>; it lasted %1 in all</source>
        <translation>；共持续 %1</translation>
    </message>
    <message>
        <source> and marked %1 of path</source>
        <translation>，留下振纹 %1</translation>
    </message>
    <message>
        <source>The overrides were not touched.</source>
        <translation>未改动倍率。</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>At</source>
        <translation>时刻</translation>
    </message>
    <message>
        <source>Chatter</source>
        <translation>颤振</translation>
    </message>
    <message>
        <source>Vibration rms</source>
        <translation>振动有效值</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>振纹</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>物理量</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>标度</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>有效值</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>峰值</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source> (assumed)</source>
        <translation>（假定）</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>info</source>
        <translation>信息</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>颤振</translation>
    </message>
    <message>
        <source>Stillcut moved speed or feed</source>
        <translation>Stillcut 调整转速或进给</translation>
    </message>
    <message>
        <source>uncalibrated</source>
        <translation>未标定</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>too short for a spectrogram</source>
        <translation>太短，无法作频谱图</translation>
    </message>
    <message>
        <source>Not computed here</source>
        <translation>此处未计算</translation>
    </message>
    <message>
        <source>The diagram does not reach this speed</source>
        <translation>叶瓣图未覆盖此转速</translation>
    </message>
    <message>
        <source>Compute the diagram first</source>
        <translation>请先计算叶瓣图</translation>
    </message>
    <message>
        <source>STABLE, %1 deeper would be too deep</source>
        <translation>稳定，再深 %1 即过深</translation>
    </message>
    <message>
        <source>CHATTER, %1 too deep</source>
        <translation>颤振，过深 %1</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>极限 %1</translation>
    </message>
    <message>
        <source>removes %1</source>
        <translation>去除率 %1</translation>
    </message>
    <message>
        <source>%1 more time</source>
        <translation>多用 %1 时间</translation>
    </message>
    <message>
        <source>%1 less time</source>
        <translation>少用 %1 时间</translation>
    </message>
    <message>
        <source>, order %1</source>
        <translation>，阶次 %1</translation>
    </message>
    <message>
        <source>fell silent</source>
        <translation>信号消失</translation>
    </message>
    <message>
        <source>loose</source>
        <translation>松动</translation>
    </message>
    <message>
        <source>left its zero</source>
        <translation>偏离零点</translation>
    </message>
    <message>
        <source>mains hum</source>
        <translation>工频干扰</translation>
    </message>
    <message>
        <source>only noise</source>
        <translation>只有噪声</translation>
    </message>
    <message>
        <source>one axis twice</source>
        <translation>同一轴重复</translation>
    </message>
    <message>
        <source>wrong rate</source>
        <translation>采样率错误</translation>
    </message>
    <message>
        <source>not tried yet</source>
        <translation>尚未试用</translation>
    </message>
    <message>
        <source>no cut</source>
        <translation>未切削</translation>
    </message>
    <message>
        <source>energy ratio</source>
        <translation>能量比</translation>
    </message>
    <message>
        <source>frequency [Hz]</source>
        <translation>频率 [Hz]</translation>
    </message>
    <message>
        <source>changes from turn to turn</source>
        <translation>逐转变化</translation>
    </message>
    <message>
        <source>learned noise floor</source>
        <translation>学得的噪声底</translation>
    </message>
    <message>
        <source>evidence of growth</source>
        <translation>增长证据</translation>
    </message>
    <message>
        <source>purity of the line</source>
        <translation>谱线纯度</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>相干</translation>
    </message>
    <message>
        <source>vibration energy</source>
        <translation>振动能量</translation>
    </message>
    <message>
        <source>warned ahead by [s]</source>
        <translation>提前预警 [s]</translation>
    </message>
    <message>
        <source>noise variance</source>
        <translation>噪声方差</translation>
    </message>
    <message>
        <source>perturbation power</source>
        <translation>扰动功率</translation>
    </message>
    <message>
        <source>largest root</source>
        <translation>最大根</translation>
    </message>
    <message>
        <source>part outside the harmonics</source>
        <translation>谐波外的部分</translation>
    </message>
    <message>
        <source>highest line</source>
        <translation>最高谱线</translation>
    </message>
    <message>
        <source>before every detector</source>
        <translation>所有检测器之前</translation>
    </message>
    <message>
        <source>detector</source>
        <translation>检测器</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>limits of the machine</source>
        <translation>机床极限</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>in charge</source>
        <translation>主用</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>does not run</source>
        <translation>未运行</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>true alarm</source>
        <translation>真报警</translation>
    </message>
    <message>
        <source>false alarm</source>
        <translation>误报</translation>
    </message>
    <message>
        <source>heard</source>
        <translation>听到</translation>
    </message>
    <message>
        <source>note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>%1: found %2 of %3, false %4 (%5 per hour), delay %6</source>
        <translation>%1：找到 %2 / %3，误报 %4（每小时 %5），延迟 %6</translation>
    </message>
    <message>
        <source>Every detector runs on it: %1</source>
        <translation>所有检测器正在运行：%1</translation>
    </message>
    <message>
        <source>Every detector has run on it</source>
        <translation>所有检测器已运行</translation>
    </message>
    <message>
        <source>Scoring: %1</source>
        <translation>评分：%1</translation>
    </message>
    <message>
        <source>Scored against what is marked</source>
        <translation>已按标记评分</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>link</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>aliased</source>
        <translation>混叠</translation>
    </message>
    <message>
        <source>%1 old, acts in %2</source>
        <translation>%1 前的数据，%2 后生效</translation>
    </message>
    <message>
        <source>No model of this path: identify it, with the tool out of the cut</source>
        <translation>此通路没有模型：请在刀具离开切削时辨识</translation>
    </message>
    <message>
        <source>Model: leaves %1 unexplained, %2 of 90° phase error left, worst at %3</source>
        <translation>模型：%1 未能解释，90° 相位误差余量 %2，最差处 %3</translation>
    </message>
    <message>
        <source>Loop delay %1, may grow by %2; identified %3 ago</source>
        <translation>回路延迟 %1，还可增加 %2；%3 前辨识</translation>
    </message>
    <message>
        <source>It promises no stable control: identify anew</source>
        <translation>它不能保证稳定控制：请重新辨识</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>启动中</translation>
    </message>
    <message>
        <source>let go: %1</source>
        <translation>已放开：%1</translation>
    </message>
    <message>
        <source>released</source>
        <translation>已释放</translation>
    </message>
    <message>
        <source>nobody renewed the lease</source>
        <translation>无人续期</translation>
    </message>
    <message>
        <source>a value was not finite</source>
        <translation>出现非有限值</translation>
    </message>
    <message>
        <source>the loop diverged</source>
        <translation>回路发散</translation>
    </message>
    <message>
        <source>the actuator was at its end and the vibration grew</source>
        <translation>执行器到达极限而振动增长</translation>
    </message>
    <message>
        <source>control made the vibration worse</source>
        <translation>控制使振动更大</translation>
    </message>
    <message>
        <source>the error sensor stands still</source>
        <translation>误差传感器没有变化</translation>
    </message>
    <message>
        <source>the device lost a block</source>
        <translation>设备丢失了一个数据块</translation>
    </message>
    <message>
        <source>stroke %1, at its end for %2 of the time</source>
        <translation>行程 %1，%2 的时间到达极限</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>行程 %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: does not run</source>
        <translation>%1：未运行</translation>
    </message>
    <message>
        <source>Identifying the paths: %1</source>
        <translation>正在辨识通路：%1</translation>
    </message>
    <message>
        <source>%1: %2, blocks of %3, worst block %4</source>
        <translation>%1：%2，每块 %3，最长一块 %4</translation>
    </message>
    <message>
        <source>%1, %2 blocks late</source>
        <translation>%1，%2 块迟到</translation>
    </message>
    <message>
        <source>, </source>
        <translation>，</translation>
    </message>
    <message>
        <source>STABLE, on an island above the limit: less depth would chatter</source>
        <translation>稳定，位于极限之上的稳定岛：切深减小反而会颤振</translation>
    </message>
    <message>
        <source>%1 told, not measured yet</source>
        <translation>标称 %1，尚未测得</translation>
    </message>
    <message>
        <source>%1 told, %2 measured</source>
        <translation>标称 %1，实测 %2</translation>
    </message>
    <message>
        <source>%1, %2 samples lost</source>
        <translation>%1，丢失 %2 个采样</translation>
    </message>
    <message>
        <source>No samples come</source>
        <translation>没有采样到达</translation>
    </message>
    <message>
        <source>%1: %2, peak %3</source>
        <translation>%1：%2，峰值 %3</translation>
    </message>
    <message>
        <source>All sensors in order</source>
        <translation>所有传感器正常</translation>
    </message>
    <message>
        <source>Sensor in order: %1</source>
        <translation>传感器正常：%1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>一次也没有</translation>
    </message>
    <message>
        <source>once</source>
        <translation>1 次</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 次</translation>
    </message>
    <message>
        <source>%1, none marked false</source>
        <translation>%1，其中无误报标记</translation>
    </message>
    <message>
        <source>%1, %2 of them marked false</source>
        <translation>%1，其中 %2 次标记为误报</translation>
    </message>
    <message>
        <source>%1 alarmed %2</source>
        <translation>%1 报警：%2</translation>
    </message>
    <message>
        <source>%1 would have alarmed %2; as recorded: %3</source>
        <translation>%1 本会报警：%2；录制时：%3</translation>
    </message>
    <message>
        <source>a loop of its own</source>
        <translation>独立回路</translation>
    </message>
    <message>
        <source>Joined device, %1 channels: %2 by this computer&apos;s clock, times steady within %3 µs, beside any constant delay of its wire</source>
        <translation>并接设备，%1 个通道：按本机时钟 %2，时间波动在 %3 µs 以内，不含其线路的固定延迟</translation>
    </message>
    <message>
        <source>No program runs, or the machine is off</source>
        <translation>没有程序在运行，或机床已关闭</translation>
    </message>
    <message>
        <source>Reading %1: %2</source>
        <translation>正在读取 %1：%2</translation>
    </message>
    <message>
        <source>time +%1</source>
        <translation>时间 +%1</translation>
    </message>
    <message>
        <source>at the next event</source>
        <translation>等待下一事件</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Marked as</source>
        <translation>标记为</translation>
    </message>
    <message>
        <source>By</source>
        <translation>标记者</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Set to</source>
        <translation>设为</translation>
    </message>
    <message>
        <source>one this program does not know</source>
        <translation>本程序不认识的参数</translation>
    </message>
    <message>
        <source>The machine is off</source>
        <translation>机床已关闭</translation>
    </message>
    <message>
        <source>The machine is off at speed %1, feed %2; Stillcut brings them back when it is on</source>
        <translation>机床已关闭，转速为 %1、进给为 %2；开机后由 Stillcut 恢复</translation>
    </message>
    <message>
        <source>The machine is in alarm</source>
        <translation>机床报警</translation>
    </message>
    <message>
        <source>No program runs</source>
        <translation>没有程序在运行</translation>
    </message>
    <message>
        <source>The program has locked both overrides (M49)</source>
        <translation>程序已锁定两个倍率（M49）</translation>
    </message>
    <message>
        <source>The spindle override has no effect: locked by the program (M51, M49), or the machine is at its limit</source>
        <translation>主轴倍率不起作用：被程序锁定（M51、M49），或机床已到极限</translation>
    </message>
    <message>
        <source>The feed override has no effect: locked by the program (M50, M49), or the machine is at its limit</source>
        <translation>进给倍率不起作用：被程序锁定（M50、M49），或机床已到极限</translation>
    </message>
    <message>
        <source>Adaptive feed has no effect: the program has not said M52 P1</source>
        <translation>自适应进给不起作用：程序中没有 M52 P1</translation>
    </message>
    <message>
        <source>LinuxCNC refuses control: is the control password right?</source>
        <translation>LinuxCNC 拒绝控制：控制密码是否正确？</translation>
    </message>
    <message>
        <source>stillcut-hal does not answer</source>
        <translation>stillcut-hal 没有应答</translation>
    </message>
    <message>
        <source>stillcut-hal has not seen the machine&apos;s watchdog act</source>
        <translation>stillcut-hal 未见机床看门狗动作</translation>
    </message>
    <message>
        <source>The machine&apos;s watchdog or the operator&apos;s switch has taken Stillcut out</source>
        <translation>机床看门狗或操作员开关已将 Stillcut 断开</translation>
    </message>
    <message>
        <source>identifying, %1</source>
        <translation>正在辨识，%1</translation>
    </message>
    <message>
        <source>%1 let go</source>
        <translation>%1 已松开</translation>
    </message>
    <message>
        <source>The active table let go along %1: %2</source>
        <translation>主动工作台沿 %1 已松开：%2</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>工作台</translation>
    </message>
    <message>
        <source>The marker is in the file</source>
        <translation>标记已写入文件</translation>
    </message>
    <message>
        <source>Vibration %1</source>
        <translation>振动 %1</translation>
    </message>
    <message>
        <source>Vibration %1: the chatter is gone</source>
        <translation>振动 %1：颤振已消除</translation>
    </message>
    <message>
        <source>Vibration %1: no chatter, %2 is the teeth</source>
        <translation>振动 %1：无颤振，%2 来自刀齿</translation>
    </message>
    <message>
        <source>Onsets in this run: %1, no chatter</source>
        <translation>本次初起：%1 次，无颤振</translation>
    </message>
    <message>
        <source>ADVICE IN THE REPLAY</source>
        <translation>回放中的建议</translation>
    </message>
    <message>
        <source>live, %1</source>
        <translation>实时，%1</translation>
    </message>
    <message>
        <source>being checked</source>
        <translation>核对中</translation>
    </message>
    <message>
        <source>regenerative</source>
        <translation>再生颤振</translation>
    </message>
    <message>
        <source>Not computed so deep</source>
        <translation>未计算到这么深</translation>
    </message>
    <message>
        <source>no limit found down to %1</source>
        <translation>直到 %1 未发现极限</translation>
    </message>
    <message>
        <source>STABLE, no limit found down to %1</source>
        <translation>稳定，直到 %1 未发现极限</translation>
    </message>
    <message>
        <source>limit deeper than %1</source>
        <translation>极限深于 %1</translation>
    </message>
    <message>
        <source>, B: %1</source>
        <translation>，B：%1</translation>
    </message>
    <message>
        <source>dB re 1 %1</source>
        <translation>dB re 1 %1</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>%1（有效值）</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>回放已暂停</translation>
    </message>
    <message>
        <source>Feed [%1]</source>
        <translation>进给 [%1]</translation>
    </message>
    <message>
        <source>Another run begins on the page Set up: GUIDE or PROFILE</source>
        <translation>在“设置”页面的“向导”或“配置”中开始新的运行</translation>
    </message>
    <message>
        <source>%1, PAUSED</source>
        <translation>%1，已暂停</translation>
    </message>
    <message>
        <source>%1, ENDED</source>
        <translation>%1，已结束</translation>
    </message>
    <message>
        <source>The onset of chatter was found once</source>
        <translation>发现一次颤振初起</translation>
    </message>
    <message>
        <source>The onset of chatter was found %1 times</source>
        <translation>发现 %1 次颤振初起</translation>
    </message>
    <message>
        <source>; it became no chatter</source>
        <translation>；未发展成颤振</translation>
    </message>
    <message>
        <source>Onset %1</source>
        <translation>初起 %1</translation>
    </message>
    <message>
        <source>%1, going on</source>
        <translation>%1，持续中</translation>
    </message>
    <message>
        <source>The controller starts, as many do when their port is opened: this takes up to 4 s</source>
        <translation>控制器正在启动（许多控制器在打开端口时会重启）：最多需要 4 秒</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>Stillcut itself stands still for %1</source>
        <translation>Stillcut 自身已停顿 %1</translation>
    </message>
    <message>
        <source>impossible values</source>
        <translation>不可能的数值</translation>
    </message>
    <message>
        <source>Leases run out</source>
        <translation>授权超时</translation>
    </message>
    <message>
        <source>Standstills</source>
        <translation>停顿</translation>
    </message>
    <message>
        <source>Less depth of cut</source>
        <translation>减小切深</translation>
    </message>
    <message>
        <source>%1 deep at most</source>
        <translation>切深不超过 %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>在 %1 时</translation>
    </message>
    <message>
        <source>ADVICE FOR YOUR HAND</source>
        <translation>建议：请手动执行</translation>
    </message>
    <message>
        <source>ADVICE FOR THE PROGRAM</source>
        <translation>建议：修改程序</translation>
    </message>
    <message>
        <source>STABLE SPEED</source>
        <translation>稳定转速</translation>
    </message>
    <message>
        <source>The spindle turns as advised and the cut is stable: keep it</source>
        <translation>主轴已按建议转动，切削稳定：请保持</translation>
    </message>
    <message>
        <source>ADVICE, AUTHORITY IS OFF</source>
        <translation>建议（权限已关闭）</translation>
    </message>
    <message>
        <source>Touch ADVISE to use it</source>
        <translation>按“建议”即可使用</translation>
    </message>
    <message>
        <source>ACTIVE, HELD BY YOU</source>
        <translation>已生效，由您保持</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>已生效</translation>
    </message>
    <message>
        <source>Vibration, uncalibrated</source>
        <translation>振动（未校准）</translation>
    </message>
    <message>
        <source>No machine link</source>
        <translation>无机床连接</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not yet back</source>
        <translation>尚未恢复</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>有应答</translation>
    </message>
    <message>
        <source>acts in %1</source>
        <translation>%1 后生效</translation>
    </message>
    <message>
        <source>louder: %1 times as before the move</source>
        <translation>更响：为调整前的 %1 倍</translation>
    </message>
    <message>
        <source>the move did not help</source>
        <translation>调整没有效果</translation>
    </message>
    <message>
        <source>%1; ended in Advise: %2 moves in a row without help</source>
        <translation>%1；已转为建议：连续 %2 次调整无效</translation>
    </message>
    <message>
        <source>Onset %1, stable after %2, nothing marked</source>
        <translation>初起 %1，%2 后稳定，无振纹</translation>
    </message>
    <message>
        <source>%1 when the tool left the cut</source>
        <translation>%1，直到刀具离开切削</translation>
    </message>
    <message>
        <source>%1, stable after %2, %3 marked</source>
        <translation>%1，%2 后稳定，振纹 %3</translation>
    </message>
    <message>
        <source>no machine link: advice is for your hand</source>
        <translation>无机床连接：建议由您手动执行</translation>
    </message>
    <message>
        <source>NOT YET BACK</source>
        <translation>尚未恢复</translation>
    </message>
    <message>
        <source>NOT YET BACK: now %1</source>
        <translation>尚未恢复：现为 %1</translation>
    </message>
    <message>
        <source>released, and the machine has not shown it yet</source>
        <translation>已交还，机床尚未显示</translation>
    </message>
    <message>
        <source>%1 active, alarms: %2, in alarm %3, energy ratio to %4</source>
        <translation>生效 %1，报警：%2，报警时长 %3，能量比最高 %4</translation>
    </message>
    <message>
        <source>The cut is stable</source>
        <translation>切削稳定</translation>
    </message>
    <message>
        <source>not stable</source>
        <translation>未稳定</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>刃数</translation>
    </message>
    <message>
        <source>the cut was stable again.</source>
        <translation>切削恢复稳定。</translation>
    </message>
    <message>
        <source>each time the cut was stable again.</source>
        <translation>每次切削均恢复稳定。</translation>
    </message>
    <message>
        <source>it did not become stable before the cut ended.</source>
        <translation>切削结束前未恢复稳定。</translation>
    </message>
    <message>
        <source>once the cut was stable again before it ended.</source>
        <translation>结束前有一次恢复稳定。</translation>
    </message>
    <message>
        <source>%1 times the cut was stable again before it ended.</source>
        <translation>结束前有 %1 次恢复稳定。</translation>
    </message>
    <message>
        <source>Stable after</source>
        <translation>稳定用时</translation>
    </message>
    <message>
        <source>Choose a device</source>
        <translation>选择设备</translation>
    </message>
    <message>
        <source>Or open files of a tap test, or drop them here.</source>
        <translation>或打开敲击试验文件，或拖到此处。</translation>
    </message>
    <message>
        <source>Opening the device</source>
        <translation>正在打开设备</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>没有采样</translation>
    </message>
    <message>
        <source>No sensor</source>
        <translation>没有传感器</translation>
    </message>
    <message>
        <source>None of its channels feels the tool.</source>
        <translation>没有通道能测到刀具。</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Without a hammer: frequencies, damping and speeds to try; no stiffness, no depth.</source>
        <translation>无力锤：仅频率、阻尼和可试转速；无刚度、无切深。</translation>
    </message>
    <message>
        <source>Press BEGIN, then hit the tip five times.</source>
        <translation>按“开始”，然后敲击刀尖五次。</translation>
    </message>
    <message>
        <source>Refused: %1.</source>
        <translation>已拒绝：%1。</translation>
    </message>
    <message>
        <source>good</source>
        <translation>好</translation>
    </message>
    <message>
        <source>double hit</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>overload of the hammer</source>
        <translation>力锤过载</translation>
    </message>
    <message>
        <source>overload of the sensor</source>
        <translation>传感器过载</translation>
    </message>
    <message>
        <source>too weak</source>
        <translation>太弱</translation>
    </message>
    <message>
        <source>it still rang</source>
        <translation>仍在振动</translation>
    </message>
    <message>
        <source>samples were lost</source>
        <translation>采样丢失</translation>
    </message>
    <message>
        <source>differs from the others</source>
        <translation>与其他不一致</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>正在读取</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>From files</source>
        <translation>来自文件</translation>
    </message>
    <message>
        <source>%1 of %2 good hits along %3</source>
        <translation>沿 %3 好的敲击 %1 / %2</translation>
    </message>
    <message>
        <source>Be quiet</source>
        <translation>请保持安静</translation>
    </message>
    <message>
        <source>The noise is being measured.</source>
        <translation>正在测量噪声。</translation>
    </message>
    <message>
        <source>HIT NOW</source>
        <translation>现在敲击</translation>
    </message>
    <message>
        <source>Listening</source>
        <translation>正在聆听</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>It still rings. %1</source>
        <translation>仍在振动。%1</translation>
    </message>
    <message>
        <source>Done along %1</source>
        <translation>%1 方向完成</translation>
    </message>
    <message>
        <source>Turn hammer and sensor and measure y, or go on to MODES.</source>
        <translation>转动力锤和传感器测量 y，或继续到“模态”。</translation>
    </message>
    <message>
        <source>Go on to MODES.</source>
        <translation>继续到“模态”。</translation>
    </message>
    <message>
        <source>Hit</source>
        <translation>敲击</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>响应</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>A touch takes it, or leaves it out</source>
        <translation>触按以采用或去除</translation>
    </message>
    <message>
        <source>Damping, %</source>
        <translation>阻尼，%</translation>
    </message>
    <message>
        <source>Soft, %</source>
        <translation>柔度，%</translation>
    </message>
    <message>
        <source>No modes yet</source>
        <translation>尚无模态</translation>
    </message>
    <message>
        <source>Measure first, or tick a mode under MODES.</source>
        <translation>请先测量，或在“模态”中勾选。</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>正在计算</translation>
    </message>
    <message>
        <source>Cannot be computed</source>
        <translation>无法计算</translation>
    </message>
    <message>
        <source>Try %1 rpm</source>
        <translation>试用 %1 rpm</translation>
    </message>
    <message>
        <source>Speeds to try: %1. At these the tool swings whole times between two teeth. How deep cannot be told: that takes the force of a hammer.</source>
        <translation>可试转速：%1。此时刀具在两齿之间振动整数次。无法得知切深：需要力锤的力。</translation>
    </message>
    <message>
        <source>Removes %1. At any speed only %2 deep.</source>
        <translation>去除率 %1。任意转速下仅 %2。</translation>
    </message>
    <message>
        <source>The tool&apos;s length ends it, not chatter.</source>
        <translation>受刀具长度限制，而非颤振。</translation>
    </message>
    <message>
        <source>Nine times in ten the true limit lies deeper; a tenth is taken off besides.</source>
        <translation>十次中有九次真实极限更深；另减去十分之一。</translation>
    </message>
    <message>
        <source>%1 teeth</source>
        <translation>%1 齿</translation>
    </message>
    <message>
        <source>Judged again: %1</source>
        <translation>重新判断：%1</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>原记录</translation>
    </message>
    <message>
        <source>The simulated cut is over</source>
        <translation>模拟切削已结束</translation>
    </message>
    <message>
        <source>AGAIN runs it once more. Your own machine: the page Set up</source>
        <translation>“再来一次”重新运行。您自己的机床：设置页</translation>
    </message>
    <message>
        <source>Stillcut moves the speed %1</source>
        <translation>Stillcut 调整转速 %1</translation>
    </message>
    <message>
        <source>Stillcut moves the feed %1</source>
        <translation>Stillcut 调整进给 %1</translation>
    </message>
    <message>
        <source>Stillcut lets go: back to the operator&apos;s overrides</source>
        <translation>Stillcut 放开：恢复操作者的倍率</translation>
    </message>
    <message>
        <source>The operator moves the speed override %1</source>
        <translation>操作者调整转速倍率 %1</translation>
    </message>
    <message>
        <source>The operator moves the feed override %1</source>
        <translation>操作者调整进给倍率 %1</translation>
    </message>
    <message>
        <source>The program asks for another speed: %1</source>
        <translation>程序要求另一转速：%1</translation>
    </message>
    <message>
        <source>Somebody has set %1</source>
        <translation>有人设置了 %1</translation>
    </message>
    <message>
        <source>the teeth shake least at %1, %2</source>
        <translation>刀齿激振最小处：%1，%2</translation>
    </message>
    <message>
        <source>without Stillcut %1</source>
        <translation>不用 Stillcut：%1</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>手动设定</translation>
    </message>
    <message>
        <source>As delivered</source>
        <translation>出厂设定</translation>
    </message>
    <message>
        <source>One step more sensitive</source>
        <translation>灵敏一级</translation>
    </message>
    <message>
        <source>One step less sensitive</source>
        <translation>迟钝一级</translation>
    </message>
    <message>
        <source>%1 steps more sensitive</source>
        <translation>灵敏 %1 级</translation>
    </message>
    <message>
        <source>%1 steps less sensitive</source>
        <translation>迟钝 %1 级</translation>
    </message>
    <message>
        <source>Looking at your last recordings</source>
        <translation>正在查看最近的录制</translation>
    </message>
    <message>
        <source>There are no recordings yet to try it on</source>
        <translation>还没有可用来试验的录制</translation>
    </message>
    <message>
        <source>In your last recording it would have alarmed %1 times, %2 of them marked false</source>
        <translation>在最近一次录制中会报警 %1 次，其中 %2 次被标为误报</translation>
    </message>
    <message>
        <source>In your last %1 recordings it would have alarmed %2 times, %3 of them marked false</source>
        <translation>在最近 %1 次录制中会报警 %2 次，其中 %3 次被标为误报</translation>
    </message>
    <message>
        <source>; as they were recorded %1 times, %2 of them marked false</source>
        <translation>；按录制时的设定为 %1 次，其中 %2 次被标为误报</translation>
    </message>
    <message>
        <source>; looking at more</source>
        <translation>；正在查看更多</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>It does not run again: %1. AGAIN tries once more</source>
        <translation>无法再次运行：%1。“再来一次”可再试</translation>
    </message>
    <message>
        <source>recordings: %1, %2</source>
        <translation>录制：%1，%2</translation>
    </message>
    <message>
        <source>alarms: %1</source>
        <translation>报警：%1</translation>
    </message>
    <message>
        <source>%1, %2 an hour, %3 long</source>
        <translation>%1，每小时 %2，共 %3</translation>
    </message>
    <message>
        <source>As the run ended</source>
        <translation>运行结束时的数值</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>Nothing was measured along %1: taken as rigid there. The true limit may be far lower; measure it first.</source>
        <translation>沿 %1 未测量：按刚性处理。真实极限可能低得多；请先测量。</translation>
    </message>
    <message>
        <source>Onset at %1, energy ratio %2</source>
        <translation>起振于 %1，能量比 %2</translation>
    </message>
    <message>
        <source>WHAT COMES NEXT</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>ADVICE, IN A MOMENT</source>
        <translation>建议，稍候</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>当前 %1</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>NETWORK</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>Too slow</source>
        <translation>过慢</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>%1 behind</source>
        <translation>落后 %1</translation>
    </message>
    <message>
        <source>What the file does not say</source>
        <translation>文件未说明的内容</translation>
    </message>
    <message>
        <source>Channel of the hammer</source>
        <translation>力锤通道</translation>
    </message>
    <message>
        <source>its name, or its number from 0</source>
        <translation>名称，或从 0 起的编号</translation>
    </message>
    <message>
        <source>Channel of the sensor</source>
        <translation>传感器通道</translation>
    </message>
    <message>
        <source>Unit of the force</source>
        <translation>力的单位</translation>
    </message>
    <message>
        <source>Unit of the response</source>
        <translation>响应的单位</translation>
    </message>
    <message>
        <source>Sensitivity of the hammer</source>
        <translation>力锤灵敏度</translation>
    </message>
    <message>
        <source>Sensitivity of the sensor</source>
        <translation>传感器灵敏度</translation>
    </message>
    <message>
        <source>Force at full scale</source>
        <translation>满量程时的力</translation>
    </message>
    <message>
        <source>in the unit beside it</source>
        <translation>以旁边的单位</translation>
    </message>
    <message>
        <source>Response at full scale</source>
        <translation>满量程时的响应</translation>
    </message>
    <message>
        <source>Unit of the frequency response</source>
        <translation>频响的单位</translation>
    </message>
    <message>
        <source>Unit of the frequencies</source>
        <translation>频率的单位</translation>
    </message>
    <message>
        <source>Unit of the phase</source>
        <translation>相位的单位</translation>
    </message>
    <message>
        <source>%1 behind: this computer does not keep up with the samples</source>
        <translation>落后 %1：本计算机跟不上采样</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>录音 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Stillcut moved speed and feed; </source>
        <translation>Stillcut 调整了转速和进给；</translation>
    </message>
    <message>
        <source>Stillcut moved speed and feed after %1 of them; </source>
        <translation>其中 %1 次后 Stillcut 调整了转速和进给；</translation>
    </message>
    <message>
        <source>Speed [%1]</source>
        <translation>转速 [%1]</translation>
    </message>
    <message>
        <source>Cut report</source>
        <translation>切削报告</translation>
    </message>
    <message>
        <source>Alarms and what was done</source>
        <translation>报警与处理</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Sensor check</source>
        <translation>传感器检查</translation>
    </message>
    <message>
        <source>Settings changed during the cut</source>
        <translation>切削中更改的设置</translation>
    </message>
    <message>
        <source>Settings at the beginning</source>
        <translation>开始时的设置</translation>
    </message>
    <message>
        <source>AUDIO</source>
        <translation>音频</translation>
    </message>
    <message>
        <source>DAQ CARD</source>
        <translation>采集卡</translation>
    </message>
    <message>
        <source>IIO</source>
        <translation>IIO</translation>
    </message>
    <message>
        <source>SERIAL</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>JOINED</source>
        <translation>组合</translation>
    </message>
    <message>
        <source>, marked: was chatter</source>
        <translation>，已标记：报警正确</translation>
    </message>
    <message>
        <source>, marked: false alarm</source>
        <translation>，已标记：误报</translation>
    </message>
    <message>
        <source>Stable again after %1</source>
        <translation>%1 后恢复稳定</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ActiveView</name>
    <message>
        <source>IDENTIFY</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>Identify the paths, with the tool out of the cut</source>
        <translation>在刀具离开切削时辨识通路</translation>
    </message>
    <message>
        <source>START</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Start active control</source>
        <translation>启动主动控制</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop active control</source>
        <translation>停止主动控制</translation>
    </message>
    <message>
        <source>Axis x</source>
        <translation>x 轴</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>y 轴</translation>
    </message>
    <message>
        <source>There is no active work-holder here.</source>
        <translation>此处没有主动工作台。</translation>
    </message>
    <message>
        <source>%1: nothing yet</source>
        <translation>%1：暂无</translation>
    </message>
    <message>
        <source>Nothing is known of its lines yet</source>
        <translation>尚无谱线信息</translation>
    </message>
    <message>
        <source>By the model, against the cut left alone: %1</source>
        <translation>按模型，与不加控制的切削相比：%1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::AdvicePanel</name>
    <message>
        <source>ACCEPT</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>NOT NOW</source>
        <translation>暂不</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>操作建议</translation>
    </message>
    <message>
        <source>AGAIN</source>
        <translation>再来一次</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::AnalyseTools</name>
    <message>
        <source>LIVE</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>WATERFALL</source>
        <translation>瀑布图</translation>
    </message>
    <message>
        <source>LINEAR</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>ORDERS</source>
        <translation>阶次</translation>
    </message>
    <message>
        <source>MAX HOLD</source>
        <translation>最大保持</translation>
    </message>
    <message>
        <source>REFERENCE</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Channel of spectrogram, spectrum and signal</source>
        <translation>频谱图、频谱与信号的通道</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>EVENTS</source>
        <translation>事件</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ChannelModel</name>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>物理量</translation>
    </message>
    <message>
        <source>Per device unit</source>
        <translation>每设备单位</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::CommandBar</name>
    <message>
        <source>OFF</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>ADVISE</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>AUTO</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>BACK TO 100 %</source>
        <translation>恢复 100 %</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>权限</translation>
    </message>
    <message>
        <source>This profile does not grant Auto</source>
        <translation>此配置不允许自动</translation>
    </message>
    <message>
        <source>END HOLD</source>
        <translation>结束保持</translation>
    </message>
    <message>
        <source>AUTO?</source>
        <translation>自动？</translation>
    </message>
    <message>
        <source>touch again to confirm</source>
        <translation>再次触按确认</translation>
    </message>
    <message>
        <source>This machine has no watchdog</source>
        <translation>此机床没有看门狗</translation>
    </message>
    <message>
        <source>if Stillcut dies, its overrides stay</source>
        <translation>若 Stillcut 失效，倍率将保留</translation>
    </message>
    <message>
        <source>F4, no watchdog</source>
        <translation>F4，无看门狗</translation>
    </message>
    <message>
        <source>ACCEPT</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>No machine link: the advice is for your hand</source>
        <translation>无机床连接：建议由您手动执行</translation>
    </message>
    <message>
        <source>No machine link: there is nothing to move</source>
        <translation>无机床连接：没有可调整的对象</translation>
    </message>
    <message>
        <source>%1, now %2</source>
        <translation>%1，现为 %2</translation>
    </message>
    <message>
        <source>cable out or keeper dead: they stay</source>
        <translation>电缆断开或守护进程终止：倍率保留</translation>
    </message>
    <message>
        <source>The run is over: there is nothing to advise on</source>
        <translation>运行已结束：没有可建议的内容</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ComponentListModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::CutForm</name>
    <message>
        <source>OPEN FILE</source>
        <translation>打开文件</translation>
    </message>
    <message>
        <source>Take a cut, a scenario, a profile or modes from a file</source>
        <translation>从文件取得切削、场景、配置或模态</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Cutting force, along</source>
        <translation>切向切削力</translation>
    </message>
    <message>
        <source>Cutting force, across</source>
        <translation>径向切削力</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>齿数</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Helix angle</source>
        <translation>螺旋角</translation>
    </message>
    <message>
        <source>Width of cut</source>
        <translation>切削宽度</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>每齿进给</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>切深</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>最低转速</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最高转速</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>ADD MODE</source>
        <translation>添加模态</translation>
    </message>
    <message>
        <source>Add a row for a mode</source>
        <translation>为模态添加一行</translation>
    </message>
    <message>
        <source>REMOVE MODE</source>
        <translation>删除模态</translation>
    </message>
    <message>
        <source>Remove the chosen mode</source>
        <translation>删除所选模态</translation>
    </message>
    <message>
        <source>SHOW LOBES</source>
        <translation>显示叶瓣图</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>顺铣</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>逆铣</translation>
    </message>
    <message>
        <source>Modes of tool and holder at the tip</source>
        <translation>刀尖处刀具和刀柄的模态</translation>
    </message>
    <message>
        <source>along</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>频率，Hz</translation>
    </message>
    <message>
        <source>damping, %</source>
        <translation>阻尼，%</translation>
    </message>
    <message>
        <source>stiffness, N/µm</source>
        <translation>刚度，N/µm</translation>
    </message>
    <message>
        <source>by its forces</source>
        <translation>按切削力</translation>
    </message>
    <message>
        <source>Your own cut: type it, or open a file</source>
        <translation>您自己的切削：输入，或打开文件</translation>
    </message>
    <message>
        <source>A cut, a scenario, a profile or modes</source>
        <translation>切削、场景、配置或模态</translation>
    </message>
    <message>
        <source>Milling direction</source>
        <translation>铣削方向</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>最大切深</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::DisplayPanel</name>
    <message>
        <source>Display</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>LIGHT</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>DARK</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>HIGH CONTRAST</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>METRIC</source>
        <translation>公制</translation>
    </message>
    <message>
        <source>INCH</source>
        <translation>英制</translation>
    </message>
    <message>
        <source>HELP</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>The manual of this page</source>
        <translation>本页的手册</translation>
    </message>
    <message>
        <source>TEXT</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>LARGE TEXT</source>
        <translation>大号文字</translation>
    </message>
    <message>
        <source>LARGEST TEXT</source>
        <translation>特大文字</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::EventPanel</name>
    <message>
        <source>What happened at 13:58, or a word</source>
        <translation>13:58 发生了什么，或一个词</translation>
    </message>
    <message>
        <source>Search the events by time of day or by a word</source>
        <translation>按时刻或词语搜索事件</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>发生了什么</translation>
    </message>
    <message>
        <source>Nothing has happened yet</source>
        <translation>尚无事件</translation>
    </message>
    <message>
        <source>Nothing like that</source>
        <translation>没有这样的事件</translation>
    </message>
    <message>
        <source>Nothing at %1. The nearest is chosen</source>
        <translation>%1 没有事件。已选中最近的一个</translation>
    </message>
    <message>
        <source>WAS CHATTER</source>
        <translation>报警正确</translation>
    </message>
    <message>
        <source>The chosen alarm was chatter</source>
        <translation>所选报警确为颤振</translation>
    </message>
    <message>
        <source>FALSE ALARM</source>
        <translation>误报</translation>
    </message>
    <message>
        <source>The chosen alarm was no chatter</source>
        <translation>所选报警不是颤振</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FileAnswerPanel</name>
    <message>
        <source>OPEN A RECORDING</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>Choose a recording to look at</source>
        <translation>选择要查看的记录</translation>
    </message>
    <message>
        <source>Your recording</source>
        <translation>您的记录</translation>
    </message>
    <message>
        <source>Reading, %1</source>
        <translation>正在读取，%1</translation>
    </message>
    <message>
        <source>Chatter or not, the reason, and the speed that helps. Drop a file on this window, or open one: sound of a phone, a table, a logger&apos;s file, a session.</source>
        <translation>是否颤振、原因，以及有用的转速。把文件拖到窗口上，或打开一个：手机录音、表格、记录仪文件、运行记录。</translation>
    </message>
    <message>
        <source>Cannot be judged</source>
        <translation>无法判断</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>Judging, %1</source>
        <translation>正在判断，%1</translation>
    </message>
    <message>
        <source>In the signal: %1 rpm</source>
        <translation>信号中：%1 r/min</translation>
    </message>
    <message>
        <source>In the signal: %1 rpm, or %2</source>
        <translation>信号中：%1 r/min，或 %2</translation>
    </message>
    <message>
        <source>Teeth by the signal: %1</source>
        <translation>按信号的齿数：%1</translation>
    </message>
    <message>
        <source>Teeth by the signal: %1, or %2</source>
        <translation>按信号的齿数：%1，或 %2</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>与 %1 比较</translation>
    </message>
    <message>
        <source>As loud in the cut as the first, if both were recorded alike</source>
        <translation>切削中与第一个一样响（若录制条件相同）</translation>
    </message>
    <message>
        <source>%1 louder in the cut than the first, if both were recorded alike</source>
        <translation>切削中比第一个响 %1（若录制条件相同）</translation>
    </message>
    <message>
        <source>%1 quieter in the cut than the first, if both were recorded alike</source>
        <translation>切削中比第一个轻 %1（若录制条件相同）</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FilePage</name>
    <message>
        <source>No recording can be opened here.</source>
        <translation>这里不能打开记录。</translation>
    </message>
    <message>
        <source>LISTEN</source>
        <translation>收听</translation>
    </message>
    <message>
        <source>Play the sound of the stretch on show</source>
        <translation>播放所示部分的声音</translation>
    </message>
    <message>
        <source>PICTURE</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Write a picture of this page beside the recording</source>
        <translation>把本页的图片写到记录旁边</translation>
    </message>
    <message>
        <source>REPORT</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Write a report of this recording beside it</source>
        <translation>把这段记录的报告写到它旁边</translation>
    </message>
    <message>
        <source>The report is being made</source>
        <translation>正在生成报告</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 无法写入</translation>
    </message>
    <message>
        <source>COMPARE</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Compare with a second recording</source>
        <translation>与第二个录制比较</translation>
    </message>
    <message>
        <source>Open the recording to compare with</source>
        <translation>打开要比较的录制</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>比较</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FileSpectrum</name>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom. Double click: all.</source>
        <translation>单击：谐波光标。H：放到最强谱线。拖动：移动。滚轮：缩放。双击：全部。</translation>
    </message>
    <message>
        <source>, order %1</source>
        <translation>，阶次 %1</translation>
    </message>
    <message>
        <source>SPECTRUM AT A, %1</source>
        <translation>A 处频谱，%1</translation>
    </message>
    <message>
        <source>SPECTRUM, MEAN</source>
        <translation>频谱，平均</translation>
    </message>
    <message>
        <source>order</source>
        <translation>阶次</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>颤振 %1</translation>
    </message>
    <message>
        <source>, compared %1</source>
        <translation>，比较 %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FileTools</name>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Samples of one spectrum</source>
        <translation>每个频谱的采样数</translation>
    </message>
    <message>
        <source>Window of the spectra</source>
        <translation>频谱的窗函数</translation>
    </message>
    <message>
        <source>Hann</source>
        <translation>汉宁</translation>
    </message>
    <message>
        <source>Flat top</source>
        <translation>平顶</translation>
    </message>
    <message>
        <source>Rectangular</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Overlap of the spectra</source>
        <translation>频谱的重叠</translation>
    </message>
    <message>
        <source>LOG</source>
        <translation>对数</translation>
    </message>
    <message>
        <source>Logarithmic axis of frequency</source>
        <translation>对数频率轴</translation>
    </message>
    <message>
        <source>ORDERS</source>
        <translation>阶次</translation>
    </message>
    <message>
        <source>Frequencies as orders of the spindle</source>
        <translation>频率用主轴阶次表示</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FrfPlot</name>
    <message>
        <source>Frequency response at the tip</source>
        <translation>刀尖频响</translation>
    </message>
    <message>
        <source>Coherence; below the mark it says little</source>
        <translation>相干；低于标线则意义不大</translation>
    </message>
    <message>
        <source>One hit only: not known</source>
        <translation>仅一次敲击：未知</translation>
    </message>
    <message>
        <source>No hammer: not known</source>
        <translation>无力锤：未知</translation>
    </message>
    <message>
        <source>Here the response of the tool appears with the first good hit.</source>
        <translation>第一次好的敲击后，此处显示刀具的响应。</translation>
    </message>
    <message>
        <source>Real part; dashed: the modes</source>
        <translation>实部；虚线：模态</translation>
    </message>
    <message>
        <source>Imaginary part</source>
        <translation>虚部</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>相位</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::HeaderBar</name>
    <message>
        <source>SIMULATED MACHINE</source>
        <translation>模拟机床</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Theme, units, language (F11); next theme (F12)</source>
        <translation>主题、单位、语言（F11）；下一主题（F12）</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::HistoryMap</name>
    <message>
        <source>SPECTROGRAM</source>
        <translation>频谱图</translation>
    </message>
    <message>
        <source>Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Click: cursor A, with Shift B.</source>
        <translation>拖动：移动。滚轮：缩放。Ctrl 加拖动：放大所选段。单击：光标 A，按 Shift 为 B。</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>等待首批采样</translation>
    </message>
    <message>
        <source>order</source>
        <translation>阶次</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::IndicatorStrip</name>
    <message>
        <source>%1, limit %2</source>
        <translation>%1，限值 %2</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>极限 %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::InterventionList</name>
    <message>
        <source>WAS CHATTER</source>
        <translation>报警正确</translation>
    </message>
    <message>
        <source>FALSE ALARM</source>
        <translation>误报</translation>
    </message>
    <message>
        <source>Last interventions</source>
        <translation>最近干预</translation>
    </message>
    <message>
        <source>LAST INTERVENTIONS</source>
        <translation>最近干预</translation>
    </message>
    <message>
        <source>None in this run</source>
        <translation>本次运行无干预</translation>
    </message>
    <message>
        <source>MISSED CHATTER</source>
        <translation>漏报颤振</translation>
    </message>
    <message>
        <source>Marks chatter now that no alarm told of; another touch takes the mark back</source>
        <translation>标记此刻未报警的颤振；再按一次撤销标记</translation>
    </message>
    <message>
        <source>%1 undoes it</source>
        <translation>%1 撤销</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LevelSpectrum</name>
    <message>
        <source>Spectrum of the first channel, now</source>
        <translation>第一通道当前频谱</translation>
    </message>
    <message>
        <source>No samples come</source>
        <translation>没有采样</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LobeChart</name>
    <message>
        <source>Stability diagram</source>
        <translation>稳定性图</translation>
    </message>
    <message>
        <source>spindle speed [rpm]</source>
        <translation>主轴转速 [rpm]</translation>
    </message>
    <message>
        <source>depth of cut [in]</source>
        <translation>切深 [in]</translation>
    </message>
    <message>
        <source>depth of cut [mm]</source>
        <translation>切深 [mm]</translation>
    </message>
    <message>
        <source>Drag the ring, or use the arrow keys: what if the cut ran at this speed and depth? Two fingers, the wheel or plus and minus zoom, zero shows the whole.</source>
        <translation>拖动圆环或用方向键：如果以此转速和切深切削会怎样？两指、滚轮或加减键缩放，0 显示全部。</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LobesPage</name>
    <message>
        <source>ZEROTH ORDER</source>
        <translation>零阶法</translation>
    </message>
    <message>
        <source>SEMI-DISCRETE</source>
        <translation>半离散法</translation>
    </message>
    <message>
        <source>EXACT</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>COMPUTE</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>Progress of the diagram</source>
        <translation>计算进度</translation>
    </message>
    <message>
        <source>What if the speed were</source>
        <translation>若转速为</translation>
    </message>
    <message>
        <source>and the depth</source>
        <translation>且切深为</translation>
    </message>
    <message>
        <source>Speed, what if</source>
        <translation>假设转速</translation>
    </message>
    <message>
        <source>Depth, what if</source>
        <translation>假设切深</translation>
    </message>
    <message>
        <source>CANCEL</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Cannot be computed: %1</source>
        <translation>无法计算：%1</translation>
    </message>
    <message>
        <source>In brackets: beyond the override&apos;s reach</source>
        <translation>括号内：超出倍率范围</translation>
    </message>
    <message>
        <source>Choose a pocket to try its best speed</source>
        <translation>选择一个区间以试用其最佳转速</translation>
    </message>
    <message>
        <source>Nothing new arrives: the working point is not shown</source>
        <translation>没有新数据：不显示工作点</translation>
    </message>
    <message>
        <source>The recording does not say which modes its tool has: there is no diagram of this cut. The machine&apos;s own comes back with its cut.</source>
        <translation>该记录没有说明其刀具的模态：此切削没有叶瓣图。回到机床的切削时，机床自己的图会恢复。</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>回放已暂停</translation>
    </message>
    <message>
        <source>The depth of cut is not known: tell it under Set up, MACHINE, and the working point is shown</source>
        <translation>切深未知：在“设置”的“机床”中填写后，将显示工作点</translation>
    </message>
    <message>
        <source>, depth of cut up to %1</source>
        <translation>，切深至 %1</translation>
    </message>
    <message>
        <source>The modes of this tool are not known. A tap test gives the file of its modes (F1 tells how): name it under Set up, TOOLS; the diagram needs nothing else.</source>
        <translation>此刀具的模态未知。锤击试验可得到模态文件（F1 说明方法）：请在“设置”的“刀具”中填写；叶瓣图不需要其他数据。</translation>
    </message>
    <message>
        <source>Stable speeds at this depth</source>
        <translation>此切深下的稳定转速</translation>
    </message>
    <message>
        <source>THE CUT THAT RUNS</source>
        <translation>当前切削</translation>
    </message>
    <message>
        <source>Lobes of the cut that runs or is replayed</source>
        <translation>正在运行或回放的切削的叶瓣图</translation>
    </message>
    <message>
        <source>YOUR OWN CUT</source>
        <translation>自定义切削</translation>
    </message>
    <message>
        <source>Enter a cut, or open a file with one</source>
        <translation>输入一个切削，或打开含有切削的文件</translation>
    </message>
    <message>
        <source>Enter tool, modes, material and engagement, or open a file: no machine and no run is needed.</source>
        <translation>输入刀具、模态、材料和啮合，或打开文件：无需机床，也无需运行。</translation>
    </message>
    <message>
        <source>Or touch YOUR OWN CUT and enter them here.</source>
        <translation>或者点“自定义切削”，在此输入。</translation>
    </message>
    <message>
        <source>BACK TO THE LOBES</source>
        <translation>返回叶瓣图</translation>
    </message>
    <message>
        <source>CHANGE YOUR CUT</source>
        <translation>修改切削</translation>
    </message>
    <message>
        <source>Computing; the diagram becomes finer until it is done</source>
        <translation>正在计算；图会逐步变细直到完成</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>正在计算</translation>
    </message>
    <message>
        <source>No speed is stable at %1. The deepest stable cut: %2 at %3</source>
        <translation>切深 %1 时没有稳定转速。最深的稳定切削：%3 时 %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MachinePlot</name>
    <message>
        <source>MACHINE</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>thick: what it did; thin: programmed; overrides: thick speed, thin feed</source>
        <translation>粗线：实际；细线：编程；倍率：粗线转速，细线进给</translation>
    </message>
    <message>
        <source>Speed, feed and overrides as they were read back</source>
        <translation>读回的转速、进给和倍率</translation>
    </message>
    <message>
        <source>Nothing was read from a machine</source>
        <translation>没有从机床读到数据</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ManualPanel</name>
    <message>
        <source>CONTENTS</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>CLOSE</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MarkSheet</name>
    <message>
        <source>Label</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Label of the span</source>
        <translation>区段的名称</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Note of the next marker</source>
        <translation>下一标记的备注</translation>
    </message>
    <message>
        <source>SPAN</source>
        <translation>区段</translation>
    </message>
    <message>
        <source>Mark the selected span with the label</source>
        <translation>用此名称标记所选区段</translation>
    </message>
    <message>
        <source>CHANGE</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>Give the chosen marker this label and note</source>
        <translation>把此名称和备注给所选标记</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Remove the chosen marker</source>
        <translation>删除所选标记</translation>
    </message>
    <message>
        <source>CHATTER</source>
        <translation>颤振</translation>
    </message>
    <message>
        <source>Mark a true alarm</source>
        <translation>标为真报警</translation>
    </message>
    <message>
        <source>FALSE</source>
        <translation>误报</translation>
    </message>
    <message>
        <source>Mark a false alarm</source>
        <translation>标为误报</translation>
    </message>
    <message>
        <source>I hear it now</source>
        <translation>我现在听到</translation>
    </message>
    <message>
        <source>NOTE</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Mark with the note</source>
        <translation>用备注标记</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Marked: %1</source>
        <translation>已标记：%1</translation>
    </message>
    <message>
        <source>Marker changed</source>
        <translation>标记已更改</translation>
    </message>
    <message>
        <source>Marker removed</source>
        <translation>标记已删除</translation>
    </message>
    <message>
        <source>Marker put back</source>
        <translation>标记已恢复</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>MISSED CHATTER</source>
        <translation>漏报颤振</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MarkerModel</name>
    <message>
        <source>, </source>
        <translation>，</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MembershipPlot</name>
    <message>
        <source>Fuzzy sets</source>
        <translation>模糊集</translation>
    </message>
    <message>
        <source>How far an error belongs to each set</source>
        <translation>误差对每个模糊集的隶属程度</translation>
    </message>
    <message>
        <source>Peaks at %1, %2, %3 of the range</source>
        <translation>峰值位于范围的 %1、%2、%3</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::OperatePage</name>
    <message>
        <source>channel %1</source>
        <translation>通道 %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::OverrideTable</name>
    <message>
        <source>Speed and feed</source>
        <translation>转速与进给</translation>
    </message>
    <message>
        <source>%1: programmed %2, override %3, actual %4 %5</source>
        <translation>%1：编程 %2，倍率 %3，实际 %4 %5</translation>
    </message>
    <message>
        <source>programmed</source>
        <translation>编程</translation>
    </message>
    <message>
        <source>override</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>实际</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ParamModel</name>
    <message>
        <source>Locked while the cut runs: the limits of the machine hold for a whole run</source>
        <translation>切削运行时锁定：机床极限在整个运行中有效</translation>
    </message>
    <message>
        <source>Locked while the cut runs: a file keeps one way of recording</source>
        <translation>切削运行时锁定：一个文件只用一种记录方式</translation>
    </message>
    <message>
        <source>Locked while the cut runs: filters and windows are sized for it before the first block</source>
        <translation>切削运行时锁定：滤波器和窗口在第一个数据块之前已据此确定</translation>
    </message>
    <message>
        <source>follows what is learned from the cut</source>
        <translation>随切削中学到的内容而定</translation>
    </message>
    <message>
        <source>chose %1</source>
        <translation>已选 %1</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1：%2（%3）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>chose %1 (%2)</source>
        <translation>选了 %1（%2）</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ParamRow</name>
    <message>
        <source>Less: %1</source>
        <translation>减小：%1</translation>
    </message>
    <message>
        <source>More: %1</source>
        <translation>增大：%1</translation>
    </message>
    <message>
        <source>AUTO</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>自动：%1</translation>
    </message>
    <message>
        <source>Not taken. Allowed: %1</source>
        <translation>未采用。允许：%1</translation>
    </message>
    <message>
        <source>%1   (A and B differ)</source>
        <translation>%1 （A 与 B 不同）</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>默认：%1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PathFitPlot</name>
    <message>
        <source>Fit of the path&apos;s model</source>
        <translation>通路模型的拟合</translation>
    </message>
    <message>
        <source>No model: identify the path</source>
        <translation>没有模型：请辨识通路</translation>
    </message>
    <message>
        <source>Phase error; hatched: control goes wrong</source>
        <translation>相位误差；阴影区：控制失效</translation>
    </message>
    <message>
        <source>Coherence; below the mark it says little</source>
        <translation>相干；低于标记时参考价值小</translation>
    </message>
    <message>
        <source>Magnitude: measured grey, model blue and dashed</source>
        <translation>幅值：实测为灰色，模型为蓝色虚线</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PocketTable</name>
    <message>
        <source>Beyond what the speed override reaches</source>
        <translation>超出转速倍率范围</translation>
    </message>
    <message>
        <source>(%1)</source>
        <translation>(%1)</translation>
    </message>
    <message>
        <source>best, rpm</source>
        <translation>最佳 rpm</translation>
    </message>
    <message>
        <source>down to</source>
        <translation>可至</translation>
    </message>
    <message>
        <source>&gt; %1</source>
        <translation>&gt; %1</translation>
    </message>
    <message>
        <source>No limit found: the search ended there</source>
        <translation>未发现极限：搜索到此为止</translation>
    </message>
    <message>
        <source>stable, rpm</source>
        <translation>稳定 rpm</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PresetBar</name>
    <message>
        <source>SAVE</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>DELETE</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>GO TO</source>
        <translation>转到</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Choose a preset, or type a name and save what is on show</source>
        <translation>选择预设，或输入名称保存当前显示</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>时刻</translation>
    </message>
    <message>
        <source>14:03:20 or -12 s</source>
        <translation>14:03:20 或 -12 s</translation>
    </message>
    <message>
        <source>No cursor: click into a plot, with Shift for B</source>
        <translation>无光标：单击图中放置，按 Shift 为 B</translation>
    </message>
    <message>
        <source>Not a moment: write 14:03:20, or -12 for seconds ago</source>
        <translation>时刻无效：请写 14:03:20，或 -12 表示多少秒前</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>撤销</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PresetList</name>
    <message>
        <source>Last 10 s</source>
        <translation>最近 10 s</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>阶次</translation>
    </message>
    <message>
        <source>Entry, 1 s</source>
        <translation>切入，1 s</translation>
    </message>
    <message>
        <source>2 min, max hold</source>
        <translation>2 min，最大保持</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::QuestionFields</name>
    <message>
        <source>Teeth</source>
        <translation>齿数</translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation>转速，r/min</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::RuleEditor</name>
    <message>
        <source>SPEED</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>Rules of the speed</source>
        <translation>转速规则</translation>
    </message>
    <message>
        <source>FEED</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>Rules of the feed</source>
        <translation>进给规则</translation>
    </message>
    <message>
        <source>Lower this rule</source>
        <translation>降低此规则</translation>
    </message>
    <message>
        <source>Raise this rule</source>
        <translation>提高此规则</translation>
    </message>
    <message>
        <source>Nothing has been learned</source>
        <translation>尚未学到任何内容</translation>
    </message>
    <message>
        <source>Lessons: %1. No rule of this table has moved</source>
        <translation>学习次数：%1。此表没有规则变动</translation>
    </message>
    <message>
        <source>Lessons: %1. Rules of this table that moved: %2, the furthest by %3</source>
        <translation>学习次数：%1。此表变动的规则：%2，最大变动 %3</translation>
    </message>
    <message>
        <source>These values cannot be used together: rules must fall as coherence rises, and the energy limit must be above its reference. Those before them still act</source>
        <translation>这些值不能一起使用：相干性升高时规则值必须下降，且能量限值必须高于能量基准。之前的值继续起作用</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::RuleGrid</name>
    <message>
        <source>Rule table</source>
        <translation>规则表</translation>
    </message>
    <message>
        <source>error %1, change %2: %3 (%4)</source>
        <translation>误差 %1，变化 %2：%3（%4）</translation>
    </message>
    <message>
        <source>%1, learned %2</source>
        <translation>%1，学得 %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SensitivityPanel</name>
    <message>
        <source>LESS SENSITIVE</source>
        <translation>更迟钝</translation>
    </message>
    <message>
        <source>MORE SENSITIVE</source>
        <translation>更灵敏</translation>
    </message>
    <message>
        <source>When it alarms: %1</source>
        <translation>何时报警：%1</translation>
    </message>
    <message>
        <source>ENERGY RATIO: full chatter from the limit on</source>
        <translation>能量比：达到限值即为完全颤振</translation>
    </message>
    <message>
        <source>EVIDENCE OF GROWTH: an onset from the limit on</source>
        <translation>增长证据：达到限值即为起振</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionList</name>
    <message>
        <source>Find job or tool</source>
        <translation>查找任务或刀具</translation>
    </message>
    <message>
        <source>JOB</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Order by job</source>
        <translation>按任务排序</translation>
    </message>
    <message>
        <source>TOOL</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Order by tool</source>
        <translation>按刀具排序</translation>
    </message>
    <message>
        <source>TIME</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Order by time</source>
        <translation>按时间排序</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>记录文件夹</translation>
    </message>
    <message>
        <source>There are no recordings to work on here.</source>
        <translation>此处没有可用的记录。</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>实录</translation>
    </message>
    <message>
        <source>Recordings of the folder</source>
        <translation>文件夹中的记录</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Simulated cuts, replayed as recordings are</source>
        <translation>模拟切削，像记录一样回放</translation>
    </message>
    <message>
        <source>No recordings here. Cuts are recorded as the page SET UP, RECORDING says.</source>
        <translation>这里没有记录。是否记录由“设置”页的“记录”决定。</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>HISTORY</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Alarms by day, tool or job over all recordings</source>
        <translation>所有录制按日、刀具或任务汇总的报警</translation>
    </message>
    <message>
        <source>recordings still to be read: %1</source>
        <translation>尚待读取的录制：%1</translation>
    </message>
    <message>
        <source>without alarms of their own, not counted: %1</source>
        <translation>自身没有报警，未计入：%1</translation>
    </message>
    <message>
        <source>No recording has this in its job, tool or date.</source>
        <translation>没有录制的任务、刀具或日期含有此内容。</translation>
    </message>
    <message>
        <source>not closed, still written or cut off, so not counted: %1</source>
        <translation>未关闭（仍在写入或被中断），故未计入：%1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionListModel</name>
    <message>
        <source>%1, tool %2, of %3</source>
        <translation>%1，刀具 %2，%3</translation>
    </message>
    <message>
        <source>%1, markers: %2</source>
        <translation>%1，标记：%2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionTimeline</name>
    <message>
        <source>Recording over time</source>
        <translation>记录随时间变化</translation>
    </message>
    <message>
        <source>Choose a recording on the left</source>
        <translation>请在左侧选择记录</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>振动</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>记录时</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>之后</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionsPage</name>
    <message>
        <source>ON ALL PAGES</source>
        <translation>所有页面</translation>
    </message>
    <message>
        <source>Show the replay on all pages</source>
        <translation>在所有页面显示回放</translation>
    </message>
    <message>
        <source>MARK</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>COMPARE</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Compare, score and export</source>
        <translation>比较、评分和导出</translation>
    </message>
    <message>
        <source>ALL DETECTORS</source>
        <translation>全部检测</translation>
    </message>
    <message>
        <source>Run every detector on this recording</source>
        <translation>在此记录上运行所有检测器</translation>
    </message>
    <message>
        <source>SCORE</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>Score this recording against its markers</source>
        <translation>按标记为此记录评分</translation>
    </message>
    <message>
        <source>SCORE ALL</source>
        <translation>文件夹评分</translation>
    </message>
    <message>
        <source>Score the whole folder</source>
        <translation>为整个文件夹评分</translation>
    </message>
    <message>
        <source>EXPORT</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Export the selected span, or the whole</source>
        <translation>导出所选区间或全部</translation>
    </message>
    <message>
        <source>REPORT</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Write a report</source>
        <translation>生成报告</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop what is being worked on</source>
        <translation>停止当前任务</translation>
    </message>
    <message>
        <source>FROM TUNE</source>
        <translation>取自调整</translation>
    </message>
    <message>
        <source>Take what was changed on the Tune page</source>
        <translation>采用“调整”页的改动</translation>
    </message>
    <message>
        <source>What if: settings, KEY=VALUE, with spaces between them</source>
        <translation>假设：参数，键=值，以空格分隔</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>假设</translation>
    </message>
    <message>
        <source>Every page shows the replay; the touches below still go to the machine</source>
        <translation>所有页面显示回放；下方按键仍作用于机床</translation>
    </message>
    <message>
        <source>Every page shows the cut again</source>
        <translation>所有页面恢复显示切削</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>No recording is open</source>
        <translation>没有打开的记录</translation>
    </message>
    <message>
        <source>%1 · %2 · alarms: %3 · in chatter %4</source>
        <translation>%1 · %2 · 报警：%3 · 颤振 %4</translation>
    </message>
    <message>
        <source>no verdict</source>
        <translation>无判定</translation>
    </message>
    <message>
        <source>Drag over the picture or choose a marked span first: the loop repeats it</source>
        <translation>请先在图上拖选或选择一段已标记的区间：循环将重复播放该段</translation>
    </message>
    <message>
        <source>AS %1</source>
        <translation>%1 格式</translation>
    </message>
    <message>
        <source>The next format of EXPORT</source>
        <translation>“导出”的下一种格式</translation>
    </message>
    <message>
        <source>Not scored: %1</source>
        <translation>未评分：%1</translation>
    </message>
    <message>
        <source>Keep this recording beside the next one that is opened</source>
        <translation>将此记录与下一个打开的记录并排</translation>
    </message>
    <message>
        <source>Open another recording: this one stays beside it, as the dashed line</source>
        <translation>打开另一记录：此记录以虚线并排显示</translation>
    </message>
    <message>
        <source>OVERLAY</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>WHOLE FILE</source>
        <translation>整个文件</translation>
    </message>
    <message>
        <source>Look at this recording as a whole, or open another file</source>
        <translation>整体查看这段记录，或打开别的文件</translation>
    </message>
    <message>
        <source>EVENTS</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>What happened in this recording</source>
        <translation>此录制中发生了什么</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SettingsForm</name>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>未设置</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>BROWSE</source>
        <translation>浏览</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>选择文件：%1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupDraft</name>
    <message>
        <source>no machine link is chosen: the program will only watch</source>
        <translation>未选择机床连接：程序仅监视</translation>
    </message>
    <message>
        <source>no device is chosen</source>
        <translation>未选择设备</translation>
    </message>
    <message>
        <source>the programmed speed is not known</source>
        <translation>编程转速未知</translation>
    </message>
    <message>
        <source>the number of flutes is not known</source>
        <translation>刃数未知</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupFinder</name>
    <message>
        <source>Hosts to look at besides this computer</source>
        <translation>除本机外还要查找的主机</translation>
    </message>
    <message>
        <source>FIND</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Look for serial ports and machines, once</source>
        <translation>查找一次串口和机床</translation>
    </message>
    <message>
        <source>USE</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>Take the chosen one as the link</source>
        <translation>把所选的作为连接</translation>
    </message>
    <message>
        <source>TEST THE LINK</source>
        <translation>测试连接</translation>
    </message>
    <message>
        <source>Test the link step by step; nothing moves</source>
        <translation>逐步测试连接；不会有任何动作</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the link with its delay into the profile</source>
        <translation>把连接及其延迟保存到配置中</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>正在查找</translation>
    </message>
    <message>
        <source>Nothing answers. A path or a host can be typed on the left.</source>
        <translation>没有应答。可在左侧输入路径或主机。</translation>
    </message>
    <message>
        <source>Nothing is looked for before you ask.</source>
        <translation>您要求之前不会查找。</translation>
    </message>
    <message>
        <source>FIND THE MACHINE</source>
        <translation>查找机床</translation>
    </message>
    <message>
        <source>more hosts, or 192.168.1.0/24</source>
        <translation>更多主机，或 192.168.1.0/24</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>查找结果</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupGuide</name>
    <message>
        <source>SHOW ME A SIMULATED CUT</source>
        <translation>显示模拟切削</translation>
    </message>
    <message>
        <source>Or connect this machine, step by step. Each step says what is still missing; nothing is commanded while authority is Off.</source>
        <translation>或逐步连接本机床。每一步说明尚缺什么；授权为“关闭”时不发出任何指令。</translation>
    </message>
    <message>
        <source>1  MACHINE</source>
        <translation>1  机床</translation>
    </message>
    <message>
        <source>2  SENSORS</source>
        <translation>2  传感器</translation>
    </message>
    <message>
        <source>3  TOOL</source>
        <translation>3  刀具</translation>
    </message>
    <message>
        <source>4  TRY OUT, SAVE, START</source>
        <translation>4  试运行并开始</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>still open</source>
        <translation>未完成</translation>
    </message>
    <message>
        <source>Look at a simulated cut first: it chatters as it gets deeper, and the program finds the stable speed. Nothing has to be connected.</source>
        <translation>先看一次模拟切削：切深增大时发生颤振，程序找到稳定转速。无需连接任何设备。</translation>
    </message>
    <message>
        <source>active</source>
        <translation>已生效</translation>
    </message>
    <message>
        <source>Three ways to begin</source>
        <translation>三种开始方式</translation>
    </message>
    <message>
        <source>LOOK AT MY RECORDING</source>
        <translation>查看我的记录</translation>
    </message>
    <message>
        <source>Or open a recording of a cut, of a phone or a logger: whether it chatters, why, and which speed helps.</source>
        <translation>或打开一段切削记录，手机或记录仪的均可：是否颤振、原因，以及哪个转速有用。</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupLimits</name>
    <message>
        <source>STILLCUT NEVER DRIVES THE MACHINE BEYOND</source>
        <translation>STILLCUT 绝不驱动机床超出</translation>
    </message>
    <message>
        <source>What the program says and the operator&apos;s own overrides are left alone. The limits are saved with the profile and hold from its START on, for the whole run.</source>
        <translation>程序所写和操作者自己的倍率不受影响。限值随配置保存，自其“启动”起在整个运行中有效。</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>无限值</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupMachine</name>
    <message>
        <source>Name of the machine</source>
        <translation>机床名称</translation>
    </message>
    <message>
        <source>Programmed speed in rpm</source>
        <translation>编程转速（rpm）</translation>
    </message>
    <message>
        <source>AUTO MAY BE CHOSEN</source>
        <translation>允许选择自动</translation>
    </message>
    <message>
        <source>Auto may be chosen on this machine</source>
        <translation>此机床允许选择自动</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation>转速 rpm</translation>
    </message>
    <message>
        <source>LINK TO THE CONTROL</source>
        <translation>与控制系统的连接</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>编程进给</translation>
    </message>
    <message>
        <source>Feed, %1</source>
        <translation>进给 %1</translation>
    </message>
    <message>
        <source>Programmed feed in %1</source>
        <translation>编程进给（%1）</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>切深</translation>
    </message>
    <message>
        <source>The depth was not taken: it must be a number from %1 to %2, or nothing where it is not known</source>
        <translation>切深未采用：必须是 %1 到 %2 之间的数，未知时留空</translation>
    </message>
    <message>
        <source>Depth, %1</source>
        <translation>切深，%1</translation>
    </message>
    <message>
        <source>Depth of cut in %1</source>
        <translation>切深（%1）</translation>
    </message>
    <message>
        <source>Deepest cut of the programme, %1 to %2; the Lobes page shows the cut at this depth</source>
        <translation>程序的最大切深，%1 到 %2；叶瓣图页面按此切深显示切削</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupPage</name>
    <message>
        <source>There is nothing to set up here.</source>
        <translation>此处无需设置。</translation>
    </message>
    <message>
        <source>GUIDE</source>
        <translation>向导</translation>
    </message>
    <message>
        <source>MACHINE</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>SENSORS</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>TOOLS</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>PROFILE</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>LIMITS</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>START</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Save what was changed and begin with it</source>
        <translation>保存更改并以此开始</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupProfile</name>
    <message>
        <source>Name of the profile</source>
        <translation>配置名称</translation>
    </message>
    <message>
        <source>TRY OUT</source>
        <translation>试运行</translation>
    </message>
    <message>
        <source>Try out step by step; nothing is commanded</source>
        <translation>逐步试运行；不发出指令</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the profile</source>
        <translation>保存配置</translation>
    </message>
    <message>
        <source>START</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>LOAD</source>
        <translation>载入</translation>
    </message>
    <message>
        <source>Load the chosen profile</source>
        <translation>载入所选配置</translation>
    </message>
    <message>
        <source>PROFILES</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>DETECTOR IN CHARGE</source>
        <translation>主用检测器</translation>
    </message>
    <message>
        <source>STRATEGY</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Save the profile and begin with it</source>
        <translation>保存配置并以其开始</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>It runs. Authority is Off.</source>
        <translation>正在运行。权限为关闭。</translation>
    </message>
    <message>
        <source>Loaded: %1</source>
        <translation>已载入：%1</translation>
    </message>
    <message>
        <source>A demonstration runs, no profile.</source>
        <translation>正在演示，无配置。</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>生效：%1</translation>
    </message>
    <message>
        <source>Try it out first: each step says what was found. Nothing is commanded.</source>
        <translation>请先试运行：每一步说明结果。不发出指令。</translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation>示例：%1</translation>
    </message>
    <message>
        <source>No device is chosen to measure with: choose one under SENSORS.</source>
        <translation>尚未选择测量设备：请在“传感器”中选择。</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupRecording</name>
    <message>
        <source>Who is at the machine</source>
        <translation>机床旁的人</translation>
    </message>
    <message>
        <source>Job: what is being made</source>
        <translation>任务：加工什么</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>记录文件夹</translation>
    </message>
    <message>
        <source>RECORD EVERY CUT</source>
        <translation>记录每次切削</translation>
    </message>
    <message>
        <source>Record every cut of this machine</source>
        <translation>记录这台机床的每次切削</translation>
    </message>
    <message>
        <source>WHAT RUNS NOW</source>
        <translation>当前运行</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>WHAT IS KEPT</source>
        <translation>保留什么</translation>
    </message>
    <message>
        <source>nothing is recorded</source>
        <translation>不记录</translation>
    </message>
    <message>
        <source>Every sample, from the beginning of the cut to its end.</source>
        <translation>从切削开始到结束的每个采样。</translation>
    </message>
    <message>
        <source>What surrounds alarms, faults and touches; the time before is held in memory until then.</source>
        <translation>报警、故障和触按前后的部分；之前的时间先保存在内存中。</translation>
    </message>
    <message>
        <source>Verdicts and indicators without samples, as a history.</source>
        <translation>只有判定和指标而没有采样的历史。</translation>
    </message>
    <message>
        <source>job</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Files are named by job, tool and time: %1</source>
        <translation>文件按任务、刀具和时间命名：%1</translation>
    </message>
    <message>
        <source>Nothing is recorded. What is chosen here begins with START on the page PROFILE.</source>
        <translation>没有记录。这里的选择在“配置”页按“启动”后生效。</translation>
    </message>
    <message>
        <source>Recording begins with the next event, and with what was before it.</source>
        <translation>记录从下一事件及其之前的部分开始。</translation>
    </message>
    <message>
        <source>Writes %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>Recording has stopped; what was recorded is in %1</source>
        <translation>记录已停止；已记录的内容在 %1</translation>
    </message>
    <message>
        <source>Deleted because of the limits: %1, the last one %2</source>
        <translation>因限额已删除 %1 个，最后一个是 %2</translation>
    </message>
    <message>
        <source>Too old or too large, but could not be deleted: %1. Free the room by hand: %2</source>
        <translation>过旧或过大但无法删除：%1 个。请手动腾出空间：%2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupSensorTrial</name>
    <message>
        <source>Level of the calibrator, as 94 dB, 1 g or 10</source>
        <translation>校准器的级，如 94 dB、1 g 或 10</translation>
    </message>
    <message>
        <source>Frequency of the calibrator in Hz</source>
        <translation>校准器频率，Hz</translation>
    </message>
    <message>
        <source>CALIBRATE</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>Hear the calibrator on the chosen channel</source>
        <translation>在所选通道上听校准器</translation>
    </message>
    <message>
        <source>KNOCK</source>
        <translation>敲击</translation>
    </message>
    <message>
        <source>Hear knocks along the axis of the chosen channel</source>
        <translation>听取沿所选通道轴向的敲击</translation>
    </message>
    <message>
        <source>Calibrator</source>
        <translation>校准器</translation>
    </message>
    <message>
        <source>Is it this sensor that lies along its axis?</source>
        <translation>该传感器是否确实沿其轴向安装？</translation>
    </message>
    <message>
        <source>The frequency is no number above 0.</source>
        <translation>频率不是大于 0 的数。</translation>
    </message>
    <message>
        <source>Listening to the calibrator</source>
        <translation>正在听校准器</translation>
    </message>
    <message>
        <source>Knock along the axis now, a few times</source>
        <translation>现在沿轴向敲击几下</translation>
    </message>
    <message>
        <source>Knock along %1 now, a few times, near the sensor</source>
        <translation>现在沿 %1 在传感器附近敲击几下</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupSensors</name>
    <message>
        <source>DEVICE</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>CHANNELS</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>ADD CHANNEL</source>
        <translation>添加通道</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>添加通道</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Remove the chosen channel</source>
        <translation>删除所选通道</translation>
    </message>
    <message>
        <source>WHAT RUNS NOW</source>
        <translation>当前运行</translation>
    </message>
    <message>
        <source>LISTEN</source>
        <translation>监听</translation>
    </message>
    <message>
        <source>Listen to the chosen device</source>
        <translation>监听所选设备</translation>
    </message>
    <message>
        <source>THE CHOSEN DEVICE</source>
        <translation>所选设备</translation>
    </message>
    <message>
        <source>Opening the device</source>
        <translation>正在打开设备</translation>
    </message>
    <message>
        <source>Take %1, which is plugged in here</source>
        <translation>选用已插入的 %1</translation>
    </message>
    <message>
        <source>Nothing is plugged in that could be heard. Plug in a microphone or a sensor: it shows here by its name.</source>
        <translation>没有可听的设备接入。插入麦克风或传感器，它会以其名称显示在此。</translation>
    </message>
    <message>
        <source>OTHER DEVICE</source>
        <translation>其他设备</translation>
    </message>
    <message>
        <source>Other kinds of devices: recordings, measuring cards, boards, networks</source>
        <translation>其他设备类型：录音、采集卡、开发板、网络</translation>
    </message>
    <message>
        <source>THREE THAT WORK, AND HOW</source>
        <translation>三种可用方案及做法</translation>
    </message>
    <message>
        <source>MICROPHONE</source>
        <translation>麦克风</translation>
    </message>
    <message>
        <source>Measurement microphone, USB sound card</source>
        <translation>测量麦克风，USB 声卡</translation>
    </message>
    <message>
        <source>IEPE SENSOR</source>
        <translation>IEPE 传感器</translation>
    </message>
    <message>
        <source>IEPE accelerometer, USB interface</source>
        <translation>IEPE 加速度计，USB 接口</translation>
    </message>
    <message>
        <source>MEMS BOARD</source>
        <translation>MEMS 板</translation>
    </message>
    <message>
        <source>MEMS board on USB, two axes</source>
        <translation>USB MEMS 板，两轴</translation>
    </message>
    <message>
        <source>The manual on it: %1</source>
        <translation>相关手册：%1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupTools</name>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Holder and stick-out</source>
        <translation>刀柄与悬伸</translation>
    </message>
    <message>
        <source>Pitch angles, degrees</source>
        <translation>齿距角（度）</translation>
    </message>
    <message>
        <source>File of its modes</source>
        <translation>模态文件</translation>
    </message>
    <message>
        <source>Highest speed, rpm</source>
        <translation>最高转速 rpm</translation>
    </message>
    <message>
        <source>KEEP</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Keep this tool</source>
        <translation>保存此刀具</translation>
    </message>
    <message>
        <source>USE IT</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Use this tool for the profile</source>
        <translation>将此刀具用于配置</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Remove this tool</source>
        <translation>删除此刀具</translation>
    </message>
    <message>
        <source>CHATTERED HERE</source>
        <translation>此处颤振</translation>
    </message>
    <message>
        <source>Note that it chatters now</source>
        <translation>记下当前颤振</translation>
    </message>
    <message>
        <source>NEW TOOL</source>
        <translation>新刀具</translation>
    </message>
    <message>
        <source>New tool</source>
        <translation>新刀具</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>even</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>无限值</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>The profile uses it now</source>
        <translation>配置已使用</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>已删除</translation>
    </message>
    <message>
        <source>Chattered at %1 rpm, %2 Hz  %3</source>
        <translation>颤振于 %1 rpm，%2 Hz  %3</translation>
    </message>
    <message>
        <source>No tools yet: begin with NEW TOOL</source>
        <translation>尚无刀具：请从“新刀具”开始</translation>
    </message>
    <message>
        <source>Noted</source>
        <translation>已记下</translation>
    </message>
    <message>
        <source>Not kept: the pitch needs one angle per tooth, 360 degrees together</source>
        <translation>未保存：齿距须每齿一个角度，合计 360 度</translation>
    </message>
    <message>
        <source>PUT IT BACK</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Put the removed tool back</source>
        <translation>恢复删除的刀具</translation>
    </message>
    <message>
        <source>It is back</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>Not kept yet</source>
        <translation>尚未保存</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>刃数</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>切削材料</translation>
    </message>
    <message>
        <source>File of its response</source>
        <translation>响应文件</translation>
    </message>
    <message>
        <source>Stick-out</source>
        <translation>悬伸长度</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>最大切深</translation>
    </message>
    <message>
        <source>Lowest speed, rpm</source>
        <translation>最低转速，rpm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Not used: %1</source>
        <translation>未使用：%1</translation>
    </message>
    <message>
        <source>modes: %1</source>
        <translation>模态：%1</translation>
    </message>
    <message>
        <source>response: %1</source>
        <translation>响应：%1</translation>
    </message>
    <message>
        <source>Not kept: the lowest speed lies above the highest</source>
        <translation>未保留：最低转速高于最高转速</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>未保留：%1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SpectraMap</name>
    <message>
        <source>SPECTROGRAM</source>
        <translation>频谱图</translation>
    </message>
    <message>
        <source>Drag: move. Wheel: zoom in time, with Ctrl in frequency. Ctrl and drag: zoom to a stretch. Double click: all. Click: cursor A, with Shift B.</source>
        <translation>拖动：移动。滚轮：缩放时间，按住 Ctrl 缩放频率。Ctrl 加拖动：放大一段。双击：全部。单击：光标 A，按住 Shift 为 B。</translation>
    </message>
    <message>
        <source>order</source>
        <translation>阶次</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>颤振 %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SpectrogramWidget</name>
    <message>
        <source>Spectrogram of the last ten seconds</source>
        <translation>最近十秒的频谱图</translation>
    </message>
    <message>
        <source>X: axis in Hz, orders or rpm. Page Up, Page Down: reach of the axis.</source>
        <translation>X：坐标轴为 Hz、阶次或 rpm。Page Up、Page Down：坐标范围。</translation>
    </message>
    <message>
        <source>no chatter</source>
        <translation>无颤振</translation>
    </message>
    <message>
        <source>chatter at %1</source>
        <translation>颤振于 %1</translation>
    </message>
    <message>
        <source>SPECTROGRAM</source>
        <translation>频谱图</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>dB re 1 %1</source>
        <translation>dB re 1 %1</translation>
    </message>
    <message>
        <source>%1, last 10 s</source>
        <translation>%1，最近 10 s</translation>
    </message>
    <message>
        <source>STALE: nothing new arrives</source>
        <translation>已过时：没有新数据</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>等待首批采样</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>order</source>
        <translation>阶次</translation>
    </message>
    <message>
        <source>now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>1× tooth</source>
        <translation>1× 齿</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SpectrumPlot</name>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom.</source>
        <translation>单击：谐波光标。H：置于最强谱线。拖动：移动。滚轮：缩放。</translation>
    </message>
    <message>
        <source>SPECTRUM</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>SPECTRUM AT A, %1</source>
        <translation>光标 A 处频谱，%1</translation>
    </message>
    <message>
        <source>SPECTRUM, NEWEST</source>
        <translation>最新频谱</translation>
    </message>
    <message>
        <source>cursor: %1</source>
        <translation>光标：%1</translation>
    </message>
    <message>
        <source>order</source>
        <translation>阶次</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>颤振 %1</translation>
    </message>
    <message>
        <source>SPECTRUM, STALE: nothing new arrives</source>
        <translation>频谱已过时：没有新数据</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::StateRows</name>
    <message>
        <source>STATES</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>low: stable, half: onset, full: chatter, hatched: not judged; line: first indicator</source>
        <translation>低：稳定，半高：起振，满高：颤振，斜线：未判断；曲线：第一指标</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::StatusStrip</name>
    <message>
        <source>State of the chain</source>
        <translation>信号链状态</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapLobePlot</name>
    <message>
        <source>Depth limits over speed</source>
        <translation>切深极限与转速</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>正在计算</translation>
    </message>
    <message>
        <source>Here the limits of the depth appear.</source>
        <translation>切深极限显示在此处。</translation>
    </message>
    <message>
        <source>Speeds to try; their depth is not known</source>
        <translation>可试转速；切深未知</translation>
    </message>
    <message>
        <source>Depth limit, hatched its uncertainty, blue what is recommended</source>
        <translation>切深极限；阴影为不确定度，蓝色为推荐</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapMeasure</name>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Hammer</source>
        <translation>力锤</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>BEGIN</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Begin the hits of this axis anew</source>
        <translation>重新开始此方向的敲击</translation>
    </message>
    <message>
        <source>FILES</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Open files of a tap test</source>
        <translation>打开敲击试验文件</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>敲击</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Files of a tap test</source>
        <translation>敲击试验文件</translation>
    </message>
    <message>
        <source>SENSOR OPPOSITE</source>
        <translation>传感器在对面</translation>
    </message>
    <message>
        <source>The sensor sits on the other side: turn the response</source>
        <translation>传感器在另一侧：反转响应</translation>
    </message>
    <message>
        <source>READ</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Read the files again with what was said</source>
        <translation>按所填内容重新读取文件</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapModes</name>
    <message>
        <source>Modes</source>
        <translation>模态</translation>
    </message>
    <message>
        <source>Name of the file of modes</source>
        <translation>模态文件名</translation>
    </message>
    <message>
        <source>KEEP</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keep the ticked modes of both axes in a file</source>
        <translation>将两个方向勾选的模态保留到文件</translation>
    </message>
    <message>
        <source>Keep as</source>
        <translation>保留为</translation>
    </message>
    <message>
        <source>Kept; a tool takes it as the file of its modes: %1</source>
        <translation>已保留；刀具可将其用作模态文件：%1</translation>
    </message>
    <message>
        <source>Not measured along %1</source>
        <translation>%1 方向未测量</translation>
    </message>
    <message>
        <source>Fitting the modes</source>
        <translation>正在拟合模态</translation>
    </message>
    <message>
        <source>A touch ticks a mode. Only ticked ones count.</source>
        <translation>触按以勾选模态。只有勾选的才算。</translation>
    </message>
    <message>
        <source>No force was measured: how stiff a mode is cannot be told.</source>
        <translation>未测力：无法得知模态刚度。</translation>
    </message>
    <message>
        <source>%1 Hz: %2</source>
        <translation>%1 Hz：%2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapPage</name>
    <message>
        <source>There is nothing to measure with here.</source>
        <translation>此处没有可用的测量设备。</translation>
    </message>
    <message>
        <source>1 HIT</source>
        <translation>1 敲击</translation>
    </message>
    <message>
        <source>2 MODES</source>
        <translation>2 模态</translation>
    </message>
    <message>
        <source>3 SPEED</source>
        <translation>3 转速</translation>
    </message>
    <message>
        <source>Axis x, along the feed</source>
        <translation>x 轴，沿进给方向</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>y 轴</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapPart</name>
    <message>
        <source>KEEP?</source>
        <translation>保存？</translation>
    </message>
    <message>
        <source>%1 is there already. Touch KEEP again to overwrite it, or give another name.</source>
        <translation>%1 已存在。再按“保存”将覆盖，或另取名称。</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapSpeeds</name>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Climb or conventional</source>
        <translation>顺铣或逆铣</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>齿数</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Width of cut</source>
        <translation>切削宽度</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>每齿进给</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>最低转速</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最高转速</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>最大切深</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>KEEP</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keep modes and cut for this tool</source>
        <translation>为此刀具保留模态和切削</translation>
    </message>
    <message>
        <source>Keep for</source>
        <translation>保留给</translation>
    </message>
    <message>
        <source>Kept: %1</source>
        <translation>已保留：%1</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>顺铣</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>逆铣</translation>
    </message>
    <message>
        <source>a file alone</source>
        <translation>仅保存文件</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TimePlot</name>
    <message>
        <source>STALE: nothing new arrives</source>
        <translation>已过时：没有新数据</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TimingFields</name>
    <message>
        <source>READ</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Read the recording with so many samples a second</source>
        <translation>按此每秒采样数读取记录</translation>
    </message>
    <message>
        <source>Samples a second</source>
        <translation>每秒采样数</translation>
    </message>
    <message>
        <source>Its times are in %1</source>
        <translation>时间单位为 %1</translation>
    </message>
    <message>
        <source>In what are its times?</source>
        <translation>时间以什么为单位？</translation>
    </message>
    <message>
        <source>Samples a second, Hz</source>
        <translation>每秒采样数，Hz</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ToolModel</name>
    <message>
        <source>chattered here before: %1</source>
        <translation>曾在此颤振：%1</translation>
    </message>
    <message>
        <source>D %1, %2 flutes</source>
        <translation>D %1，%2 刃</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TracePlot</name>
    <message>
        <source>SIGNAL</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>No samples kept of this stretch</source>
        <translation>此段未保留采样</translation>
    </message>
    <message>
        <source>peak %1</source>
        <translation>峰值 %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TrackPlot</name>
    <message>
        <source>DETECTORS</source>
        <translation>检测器</translation>
    </message>
    <message>
        <source>Low: stable. Half: onset. Full: chatter. Hatched: no verdict. The line is the first indicator.</source>
        <translation>低：稳定。半高：开始。满高：颤振。阴影：无结论。曲线为第一指标。</translation>
    </message>
    <message>
        <source>low: stable, half: onset, full: chatter; line: first indicator</source>
        <translation>低：稳定，半：初起，满：颤振；曲线：第一指标</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TransportBar</name>
    <message>
        <source>To the beginning</source>
        <translation>到开头</translation>
    </message>
    <message>
        <source>A block back</source>
        <translation>后退一块</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>A block on</source>
        <translation>前进一块</translation>
    </message>
    <message>
        <source>LOOP</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Repeat the selected span</source>
        <translation>重复所选区间</translation>
    </message>
    <message>
        <source>Pace of the replay</source>
        <translation>回放速度</translation>
    </message>
    <message>
        <source>PAUSE</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>%1 x</source>
        <translation>%1 x</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>最快</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TunePage</name>
    <message>
        <source>Methods</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>REDO</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>DEFAULTS</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>WHAT IT SEES NOW</source>
        <translation>当前所见</translation>
    </message>
    <message>
        <source>COMPARE</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>A = B</source>
        <translation>A = B</translation>
    </message>
    <message>
        <source>Use the values of side A</source>
        <translation>使用 A 侧的值</translation>
    </message>
    <message>
        <source>Use the values of side B</source>
        <translation>使用 B 侧的值</translation>
    </message>
    <message>
        <source>Make the other side like this one</source>
        <translation>使另一侧与此相同</translation>
    </message>
    <message>
        <source>Nothing to tune: this session has no methods of its own</source>
        <translation>无可调整：此会话没有自己的方法</translation>
    </message>
    <message>
        <source>B = A</source>
        <translation>B = A</translation>
    </message>
    <message>
        <source>Both sides are alike. Take B, change something, and go to and fro.</source>
        <translation>两侧相同。选 B，改动后来回切换。</translation>
    </message>
    <message>
        <source>Values that differ: %1</source>
        <translation>不同的值：%1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>It does not run</source>
        <translation>未运行</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>已保存到 %1</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>未保存：%1</translation>
    </message>
    <message>
        <source>The picture is stale: nothing new for %1</source>
        <translation>画面已过时：%1 无新数据</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>回放已暂停</translation>
    </message>
    <message>
        <source>Learned by itself</source>
        <translation>自行学得</translation>
    </message>
    <message>
        <source>REVERT</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>EXPERT</source>
        <translation>专家</translation>
    </message>
    <message>
        <source>Expert: every method and each of its parameters</source>
        <translation>专家：每种方法及其各个参数</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TuningController</name>
    <message>
        <source>to the defaults</source>
        <translation>恢复默认</translation>
    </message>
    <message>
        <source>as the run began</source>
        <translation>恢复到开始时</translation>
    </message>
    <message>
        <source>both sides alike</source>
        <translation>两侧相同</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::VerdictSign</name>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::WavePlot</name>
    <message>
        <source>SIGNAL</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Double click: all. Click: cursor A, with Shift B.</source>
        <translation>拖动：移动。滚轮：缩放。Ctrl 加拖动：放大一段。双击：全部。单击：光标 A，按住 Shift 为 B。</translation>
    </message>
    <message>
        <source>below: %1</source>
        <translation>下方：%1</translation>
    </message>
</context>
</TS>
