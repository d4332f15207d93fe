<?xml version='1.0' encoding='utf-8'?>
<TS version="2.1" language="zh_CN">
<context>
    <name>Core</name>
    <message>
        <source>High-pass edge</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Removes offset and drift below this frequency; auto: a quarter of the spindle frequency</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Doubt of the told speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>How far the told spindle speed may be from the true one, as a ratio; searched at entry</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Cut above air</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>A cut is this much louder than the quietest the sensor has heard</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Harmonics</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spindle harmonics of the periodic part (L, eq. 9); auto: 32 as the rate allows</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>NLMS step</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>mu of eq. 19; auto: a memory of two turns (paper: 0.5)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>NLMS leak</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>lambda of eq. 19; auto: leaves 1 % of a harmonic (paper: 0.9995)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>AR drift</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>R_v of eq. 21, for a signal of unit variance</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>AR noise</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>R_w of eq. 21, for a signal of unit variance</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Reflected distance</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Distance from the unit circle at which an unstable root is put back inside</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Working rate</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Least rate the method works at; auto: 10 kHz, as the paper</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Variance limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Variance of the residual (squared unit of the sensor) that is an alarm; auto: growth above the learned floor</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Root of an alarm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Magnitude of the dominant root below which the residual is noise and not chatter</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Evidence for onset</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Log-likelihood ratio of growth against the learned floor that makes an onset (onset_test.h)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Chatter ratio</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Energy ratio from which a cut is in full chatter</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Length of the spectrum; auto: 28 turns, at most 1.5 s (paper: 0.512 s)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spectra per window</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>A new spectrum is taken this often within one window</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Line threshold</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Amplitude (unit of the sensor) of a line that is chatter; auto: growth above the learned floor</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Mask</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Half width of the mask on a harmonic, in bins</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Purity</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Part of the power between the harmonics that a chatter line holds at least</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spindle harmonics the Kalman filter removes (N, eq. 16); auto: 12 tooth passings, at least 32, as the sampling rate allows</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Process noise ratio</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Q/R of the Kalman filter (eq. 20); auto: a memory of two turns</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Covariance</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Covariance of the Kalman filter: its settled gain from the start, or eq. 20 at every sample, which is right from the first turn on and costs some twenty times as much</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>settled</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>full</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Energy ratio (eq. 28) from which a cut is in full chatter</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Smallest onset</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Unrepeated vibration over all vibration (amplitudes) below which growth is not yet called onset</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Log-likelihood ratio of growth against the learned noise that makes an onset; a stable cut lasts e to this power turns, on average, without a false alarm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Coherence</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>welch: averaged magnitude-squared coherence; paper: eq. 3-5 of one transform</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>welch</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>paper</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Sharpening</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Weighting of the smoothed coherence; printed: eq. 3-17b as it stands</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>monotone</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>printed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Segment</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Length of one transform; auto: 12 turns, at most 1 s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Averages</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Memory of the averages, in segments (each overlaps the last by 7/8)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Window from</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Where the window of eq. 3-18 begins to rise (paper: 170 Hz); auto: no window</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Window to</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Where the window of eq. 3-18 has fallen (paper: 250 Hz); auto: no window</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Coherence reference</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>gamma_ref: coherence ratio that is chatter's</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Energy reference</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>E_ref (unit of the sensor) of eq. 3-21; auto: growth above the learned floor</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Part of the cross spectrum between the harmonics that a chatter line holds at least</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Confirmation</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>How long an alarm stands at one frequency before the first move</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Confirmation after a move</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>How long chatter stands at the new speed before that speed is given up</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Settling</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>After the spindle has reached a new speed it is judged no sooner</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speeds to try</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>After so many speeds without quiet it goes back and advises only</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Memory of tried speeds</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>After so long without an alarm the tried speeds are forgotten</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Pause after giving up</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>So long nothing is tried again after no speed was quiet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Smoothing of the frequency</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Time constant of the low-pass on the chatter frequency</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Act on</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Move at the onset of chatter, or only when it is full chatter</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>onset</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>chatter</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Freeze when quiet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Stay at the actual speed once chatter clears, for narrow lobes, instead of going on to the last target</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Step size</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>mu_c of eq. 32</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Smoothing of the level</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>lambda_c of eq. 33</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Unit of a step</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>What a step of 1 in eq. 32 is, in percent of the programmed speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Control period</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Time from one step of eq. 32 to the next</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Step of the search</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Distance of neighbouring trials, in percent of the programmed speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Time per trial</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The vibration at each trial is averaged this long</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speeds to choose from: the nearest, only lower, only higher</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>nearest</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>down</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>up</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Phase factor</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Fraction of a wave left between two cuts (nu of eq. 3)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Control cycle</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speed and feed are changed once per cycle</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Time for the whole range</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>At full output the whole range of an override takes this long (the paper's limit: a second)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Coherence above which speed and feed fall (gamma_ref)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Vibration over that of the stable cut above which speed and feed fall</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Energy limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Vibration over that of the stable cut at which the feed goes to its lowest; at twice that the feed is held</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest overrides</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speed and feed rise no further than this share of the programmed values</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Rest of the speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The speed does not rise for so long after an alarm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Learning weight</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Share of the coherence error that the rules learn (w of eq. 3-32)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Direct tuning</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>By coherence alone (eq. 3-37) or by coherence and energy (3-36)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>single</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>double</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Coherence weight</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Weight of the coherence error (w_gamma of eq. 3-34)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Energy weight</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Weight of the energy error (w_E of eq. 3-35)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Lowest speed override</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spindle speed is never driven below this share of the programmed speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest speed override</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spindle speed is never driven above this share of the programmed speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Lowest feed override</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed is never driven below this share of the programmed feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest feed override</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed is never driven above this share of the programmed feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Lowest speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spindle speed is never driven below this; auto: no such limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spindle speed is never driven above this: the machine's limit; auto: none</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest speed of the tool</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>What the maker allows the tool; auto: no such limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest speed of the holder</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>What holder and balancing allow; auto: no such limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest cutting speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The edge is never driven faster than this; needs the tool's diameter; auto: no such limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Lowest feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed is never driven below this; auto: no such limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed is never driven above this; auto: no such limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Lowest feed per tooth</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Our overrides never lower the feed per tooth below this share of the programmed one: the edge would rub</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Highest feed per tooth</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Our overrides never raise the feed per tooth above this share of the programmed one</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speed change per step</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Largest change of the speed override in one step of the gate, in percent of the programmed speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speed change per second</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Fastest change of the speed override, in percent of the programmed speed per second</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed change per step</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Largest change of the feed override in one step of the gate, in percent of the programmed feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed change per second</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Fastest change of the feed override, in percent of the programmed feed per second</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Recovery rate</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Rate of the way back toward 100 % when nothing chatters, as a share of the rate away from it</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Smoothing</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Time constant of the low-pass on the wanted overrides</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Dead band</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Wanted changes up to this are not worth moving the machine</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Changes per minute</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Moves that start from rest or turn back, at most so many in any minute</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Cool-down</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Pause after the changes per minute are used up; the second time Auto falls back to Advise</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speed tolerance</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The spindle counts as at speed, and an override as taken, within this</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Machine state age</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>A machine state older than this is stale</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Verdict age</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>A verdict or request older than this is stale</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Hold before release</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>On bad input the overrides are held this long, then the programmed values come back</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Rest after release</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>After a release the input must be good for this long before the overrides are taken again</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Pause after the knob</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>After the operator turned a knob nothing new is asked this long</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Time to take an override</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The override read back must agree with the command within this, or the machine is let go</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Time for the spindle to follow</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The spindle must reach the commanded speed within this, or the machine is let go</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Lease</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>A command that is not renewed within this ends, and the programmed values come back</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>What is kept: everything, what surrounds events, or verdicts and indicators alone</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>continuous</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>around-events</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>features</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Kept before an event</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Around events: how much is kept from before each</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Kept after an event</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Around events: how long recording goes on after the last</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Step of the history</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Features: one step is kept in so long, and every one with an event</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Length of the history</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Features: what is older goes</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Keep recordings for</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Older recordings without a marker are deleted when a new one begins</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Keep recordings up to</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The oldest recordings without a marker are deleted beyond it</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Taps</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Length of the adaptive filter of each axis (Ford 2013 table 3: 35)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Adaptation step mu; while 'normalised' is on, as a share of the largest stable step</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Normalised</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Take the step as a share of the bound that follows the power of the filtered reference</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Leak</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Factor on the weights at each sample (gamma of eq. 2); 1 forgets nothing</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>What the filter works from: the error itself, or the disturbance as the model sees it</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>error</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>internal-model</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Path taps</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Length of each part of the recursive model from actuator to sensor (table 3: 35)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Parametric</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spectral line</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Energy ratio</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Monitoring only</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Next stable pocket, checked</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Centre of the lobe</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Toward less vibration</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Least vibration</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Quarter wave between teeth</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Fuzzy speed and feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Fuzzy, learning its rules</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Fuzzy, outputs tuned directly</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The control of the simulated mill; the only one that takes commands from a replay</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>LinuxCNC through linuxcncrsh and halrmt: host, port, hal_port</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>GRBL 1.1 or grblHAL on a serial port or a host: device, baud; host, port</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>A spindle drive or PLC by Modbus TCP or RTU: map, a file of registers</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Override voltages through a Comedi card: map, a file of calibration tables</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>A simulated cut from a scenario file, in real time or as fast as possible</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Operate</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Analyse</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Lobes</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>PlotFrame</name>
    <message>
        <source>time [s]</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>Spectrogram of %1 [kHz]</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Vibration of %1, rms [%2]</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Energy ratio, chatter to all</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Spindle speed [rpm]</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>Auto</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Advise</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>still learning the noise, {0.1} s to go</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the spindle speed is not known</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the number of teeth is not known</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} samples are missing</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the sensor is at its limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>channel {0.0} delivers values that are not numbers</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>channel {0.0} delivers a constant</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the spindle is running up, {0.0} rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the tool is entering or leaving, {0.2} s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>energy ratio {0.2} is over {1.2}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>energy ratio {0.3} grows above its floor of {1.3}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>a line at {2.1} Hz between the harmonics holds {0.3} of the vibration, over {1.3}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>vibration that the harmonics leave, {0.3} of all, is over {1.3}, strongest at {2.1} Hz</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>coherence ratio {0.2} is over {1.2} at {2.1} Hz and its energy grows</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>coherence needs two channels, there are {0.0}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>detector {0.0} failed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>nothing to do</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} rpm puts {1.0} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>feed follows to {0.0} mm/min, so that each tooth still takes {1.3} mm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} rpm would help but the override reaches {1.0} to {2.0} rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>monitoring only</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>there is no usable verdict to act on</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>going back towards {0.2}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} rpm is already the speed for chatter at {1.0} Hz</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>quiet, keeping {0.0} rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} rpm with {1.0} waves between two teeth is in reach, {2.0} rpm is not (chatter {3.0} Hz)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} rpm puts {1.2} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} rpm brings a tooth harmonic closer to the chatter, {1.1} Hz apart, level {2.2} of its mean</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>trying {0.0} rpm for less vibration, now {1.4}, best so far {2.4} at {3.0} rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} rpm vibrates least, {1.4}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} rpm lies between the stability limits at {1.0} and {2.0} rpm (chatter {3.0} Hz)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>no speed in reach is stable at this depth, {1.2} mm at {2.0} rpm would be (chatter {3.0} Hz)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} speeds tried and none is quiet (chatter {1.0} Hz), a smaller depth is needed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>coherence {0.2} and energy {1.1} times that of the stable cut ask for {2.0} rpm and {3.0} mm/min</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>authority is off</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>advice only</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the request was not a number</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>asked for {0.2}, limits allow {1.2}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the machine's state is {0.2} s old</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the verdict is {0.2} s old</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the machine is not running a program</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>held by the operator</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>waiting for the spindle, {0.0} of {1.0} rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} changes in a minute, {1.0} allowed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the programmed values are back in force</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>no fresh command for {0.2} s, programmed values restored</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>speed {0.1} % and feed {1.1} %, with the knobs {2.1} % and {3.1} %</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>speed {0.1} % on its way to {1.1} %, feed {2.1} % to {3.1} %</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>what the machine reports makes no sense</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the program has locked the overrides</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>something else controls the overrides</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the detector's verdict is not usable</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the request is {0.2} s old</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>time stood still, jumped or went back</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the tool is not in the cut</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the feed is on hold</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the operator turns the knobs: speed {0.0} %, feed {1.0} %</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the spindle does not follow, {0.0} instead of {1.0} rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the machine does not take the override, {0.1} % instead of {1.1} %</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the program went from {0.0} to {1.0} rpm, starting again from 100 %</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>waiting {0.1} s before taking the overrides again</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>too many changes, waiting {0.0} s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Auto is not allowed in this set-up</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>more than {0.0} changes in a minute again, advice only from now on</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the operator accepted {0.0} rpm and {1.0} mm/min</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the operator refused {0.0} rpm and {1.0} mm/min</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>chatter at {0.0} Hz, energy ratio {1.2}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>quiet again after {0.2} s and {1.1} mm of feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>authority changed from {0.0} to {1.0}</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>back to 100 % at the operator's wish</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the machine has not answered for {0.2} s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the machine answers again</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>recording has stopped</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>{0.0} blocks were dropped</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Auto is granted because this machine is simulated</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the strategy failed, monitoring only from now on</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the advice has changed to {0.0} rpm and {1.0} mm/min, it needs another touch</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>ReportPages</name>
    <message>
        <source>Cut report</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Alarms and what was done</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Before: highest until the first command. After: newest at the end of the alarm. Numbers are those in the plots.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Events</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Sensor check</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Settings in force</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui</name>
    <message>
        <source>%1 rpm, %2</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Costs no time</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Costs %1 time</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Saves %1 time</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>cutting speed %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The feed stays as it is</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed follows: %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The speed stays as it is</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>ADVICE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Back to 100 %</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>ASKED FOR, NOT CONFIRMED BY THE MACHINE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>IN FORCE, HELD BY YOU</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>IN FORCE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>WHAT TO DO</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>No advice</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>There is no live picture to advise on</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Nothing to do</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Authority is off: Stillcut only watches</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>There is no verdict to act on</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The strategy has not decided yet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>about %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The machine does not answer; last values %1 old</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Values are %1 old</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Another program has the overrides</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The program has switched overrides off</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed hold</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Energy ratio</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Vibration</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Coherence</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Nothing was read from the machine yet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Knobs %1, %2</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Machine</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>not read yet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>no answer for %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Sensor</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>no samples yet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>nothing for %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>at its limit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>dead</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>not a number</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>samples missing</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>ok</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1, %2 lost</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Chatter %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1, acting</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1, not quieted</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1, quiet after %2, %3 marked</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1, %2 more time</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>chatter %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Drops</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Overruns</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Block age</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>You are in command</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>speed %1, feed %2</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Stillcut is in command</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>You are in command, Stillcut advises</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>since %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1, on this simulated machine</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>as last heard, %1 ago</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>held by you, %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>NO CUT</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>STABLE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>ONSET</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>CHATTER</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Hopf</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>period doubling</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>forced vibration</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>growing</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>steady</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>dying down</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The tool is in the air</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The spindle is running up</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The tool is entering</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The tool is leaving</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>No chatter in this run</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>In chatter so far: %1, %2</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>NO VERDICT</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The picture is stale: nothing new for %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Last verdict: %1 %2</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>For %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>For %1, %2 of feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The run has ended</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The detector gives no reason</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Early warning: vibration begins to grow</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The cut is quiet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The tool does not cut</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Auto: Stillcut commanded the overrides</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Advise: Stillcut proposed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Off: Stillcut watched</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>no signal: check cable and supply</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>clipped: lower the gain</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>large constant part: check coupling</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>far weaker than the others: loose?</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>in order</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>quiet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>cut ended</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>not quiet</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>not answered</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source> (simulated)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>, diameter </source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Teeth</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Programmed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>mm/min</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Authority</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Sensors</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1 at %2 Hz</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Missing</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1 in %2 gaps</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>not closed: ends where it was cut off</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Recorded by</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>This recording holds measurements only: nobody decided while it was made. Vibration and spectrogram are shown as they are.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>No chatter was found.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Chatter began once</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Chatter began %1 times</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>, first at %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Hz</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>; it lasted %1 in all</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source> and marked %1 of path</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The overrides were not touched.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Stillcut moved speed and feed once; </source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Stillcut moved speed and feed %1 times; </source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>the cut was quiet again.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>each time the cut was quiet again.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>it did not become quiet before the cut ended.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>once the cut was quiet again before it ended.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1 times the cut was quiet again before it ended.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>At</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Chatter</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Feed [mm/min]</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Vibration rms</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Quiet after</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Marked</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Outcome</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>rms</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Peak</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Check</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source> (assumed)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Level</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>fault</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>warning</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>info</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>stable</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>onset</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>chatter</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Stillcut moved speed or feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>uncalibrated</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>dB</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>too short for a spectrogram</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Not computed here</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The diagram does not reach this speed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Compute the diagram first</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>STABLE, %1 deeper would be too deep</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>CHATTER, %1 too deep</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>limit %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>removes %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1 more time</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1 less time</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>, order %1</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::AdvicePanel</name>
    <message>
        <source>ACCEPT</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>NOT NOW</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>What to do</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::AnalyseTools</name>
    <message>
        <source>LIVE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>WATERFALL</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>LINEAR</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>ORDERS</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>MAX HOLD</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>REFERENCE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Channel</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Channel of spectrogram, spectrum and signal</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::CommandBar</name>
    <message>
        <source>OFF</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>ADVISE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>AUTO</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>HOLD</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>BACK TO 100 %</source>
        <translation>恢复 100 %</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>This profile does not grant Auto</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>END HOLD</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Esc, now %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>AUTO?</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>touch again to confirm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>This machine has no watchdog</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>if Stillcut dies, its overrides stay</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::DisplayPanel</name>
    <message>
        <source>Display</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>LIGHT</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>DARK</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>HIGH CONTRAST</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>METRIC</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>INCH</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::HeaderBar</name>
    <message>
        <source>SIMULATED MACHINE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Display</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Theme, units, language (F11); next theme (F12)</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::HistoryMap</name>
    <message>
        <source>SPECTROGRAM</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Click: cursor A, with Shift B.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>order</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::InterventionList</name>
    <message>
        <source>WAS CHATTER</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>FALSE ALARM</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Last interventions</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>LAST INTERVENTIONS</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>None in this run</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::LobeChart</name>
    <message>
        <source>Stability diagram</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Drag the ring, or use the arrow keys: what if the cut ran at this speed and depth?</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>spindle speed [rpm]</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>depth of cut [in]</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>depth of cut [mm]</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::LobesPage</name>
    <message>
        <source>ZEROTH ORDER</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>SEMI-DISCRETE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>EXACT</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>COMPUTE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Progress of the diagram</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>What if the speed were</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>and the depth</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Speed, what if</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Depth, what if</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Quiet pockets at this depth</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Choose a pocket to try its best speed. In brackets: beyond the override's reach.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>The modes of this tool are not known. Measure them with a hammer (Set up) or name a model file in the profile; the diagram needs nothing else.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>CANCEL</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Computing; the diagram before stays until it is done</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1. Left out: %2</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Cancelled</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Cannot be computed: %1</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::OperatePage</name>
    <message>
        <source>channel %1</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::OverrideTable</name>
    <message>
        <source>Speed and feed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1: programmed %2, override %3, actual %4 %5</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>programmed</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>override</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>actual</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::PocketTable</name>
    <message>
        <source>Beyond what the speed override reaches</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>(%1)</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>quiet, rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>best, rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>down to</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>removes</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::PresetBar</name>
    <message>
        <source>SAVE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>DELETE</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>GO TO</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Choose a preset, or type a name and save what is on show</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Moment</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>14:03:20 or -12 s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>No cursor: click into a plot, with Shift for B</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Not a moment: write 14:03:20, or -12 for seconds ago</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::PresetList</name>
    <message>
        <source>Last 10 s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Orders</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Entry, 1 s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>2 min, max hold</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::SpectrogramWidget</name>
    <message>
        <source>Spectrogram of the last ten seconds</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>X: axis in Hz, orders or rpm. Page Up, Page Down: reach of the axis.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>no chatter</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>chatter at %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>SPECTROGRAM</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>dB</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>dB re 1 %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1, last 10 s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>STALE: nothing new arrives</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Hz</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>order</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>rpm</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>1× tooth</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>%1×</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::SpectrumPlot</name>
    <message>
        <source>Spectrum</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom.</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>SPECTRUM</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>SPECTRUM AT A, %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>SPECTRUM, NEWEST</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>cursor: %1</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>order</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>chatter %1</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::StatusStrip</name>
    <message>
        <source>State of the chain</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::TimePlot</name>
    <message>
        <source>STALE: nothing new arrives</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::TracePlot</name>
    <message>
        <source>SIGNAL</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>No samples kept of this stretch</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::TrackPlot</name>
    <message>
        <source>DETECTORS</source>
        <translation type="unfinished" />
    </message>
    <message>
        <source>Low: stable. Half: onset. Full: chatter. Hatched: no verdict. The line is the first indicator.</source>
        <translation type="unfinished" />
    </message>
</context>
<context>
    <name>stillcut::ui::VerdictSign</name>
    <message>
        <source>Verdict</source>
        <translation type="unfinished" />
    </message>
</context>
</TS>