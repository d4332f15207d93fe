<?xml version='1.0' encoding='utf-8'?>
<TS version="2.1" language="en_US">
<context>
    <name>Core</name>
    <message>
        <source>High-pass edge</source>
        <translation>High-pass edge</translation>
    </message>
    <message>
        <source>Removes offset and drift below this frequency; auto: a quarter of the spindle frequency</source>
        <translation>Removes offset and drift below this frequency; auto: a quarter of the spindle frequency</translation>
    </message>
    <message>
        <source>Doubt of the told speed</source>
        <translation>Doubt of the told speed</translation>
    </message>
    <message>
        <source>How far the told spindle speed may be from the true one, as a ratio; searched at entry</source>
        <translation>How far the told spindle speed may be from the true one, as a ratio; searched at entry</translation>
    </message>
    <message>
        <source>Cut above air</source>
        <translation>Cut above air</translation>
    </message>
    <message>
        <source>A cut is this much louder than the quietest the sensor has heard</source>
        <translation>A cut is this much louder than the quietest the sensor has heard</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmonics</translation>
    </message>
    <message>
        <source>Spindle harmonics of the periodic part (L, eq. 9); auto: 32 as the rate allows</source>
        <translation>Spindle harmonics of the periodic part (L, eq. 9); auto: 32 as the rate allows</translation>
    </message>
    <message>
        <source>NLMS step</source>
        <translation>NLMS step</translation>
    </message>
    <message>
        <source>mu of eq. 19; auto: a memory of two turns (paper: 0.5)</source>
        <translation>mu of eq. 19; auto: a memory of two turns (paper: 0.5)</translation>
    </message>
    <message>
        <source>NLMS leak</source>
        <translation>NLMS leak</translation>
    </message>
    <message>
        <source>lambda of eq. 19; auto: leaves 1 % of a harmonic (paper: 0.9995)</source>
        <translation>lambda of eq. 19; auto: leaves 1 % of a harmonic (paper: 0.9995)</translation>
    </message>
    <message>
        <source>AR drift</source>
        <translation>AR drift</translation>
    </message>
    <message>
        <source>R_v of eq. 21, for a signal of unit variance</source>
        <translation>R_v of eq. 21, for a signal of unit variance</translation>
    </message>
    <message>
        <source>AR noise</source>
        <translation>AR noise</translation>
    </message>
    <message>
        <source>R_w of eq. 21, for a signal of unit variance</source>
        <translation>R_w of eq. 21, for a signal of unit variance</translation>
    </message>
    <message>
        <source>Reflected distance</source>
        <translation>Reflected distance</translation>
    </message>
    <message>
        <source>Distance from the unit circle at which an unstable root is put back inside</source>
        <translation>Distance from the unit circle at which an unstable root is put back inside</translation>
    </message>
    <message>
        <source>Working rate</source>
        <translation>Working rate</translation>
    </message>
    <message>
        <source>Least rate the method works at; auto: 10 kHz, as the paper</source>
        <translation>Least rate the method works at; auto: 10 kHz, as the paper</translation>
    </message>
    <message>
        <source>Variance limit</source>
        <translation>Variance limit</translation>
    </message>
    <message>
        <source>Variance of the residual (squared unit of the sensor) that is an alarm; auto: growth above the learned floor</source>
        <translation>Variance of the residual (squared unit of the sensor) that is an alarm; auto: growth above the learned floor</translation>
    </message>
    <message>
        <source>Root of an alarm</source>
        <translation>Root of an alarm</translation>
    </message>
    <message>
        <source>Magnitude of the dominant root below which the residual is noise and not chatter</source>
        <translation>Magnitude of the dominant root below which the residual is noise and not chatter</translation>
    </message>
    <message>
        <source>Evidence for onset</source>
        <translation>Evidence for onset</translation>
    </message>
    <message>
        <source>Log-likelihood ratio of growth against the learned floor that makes an onset (onset_test.h)</source>
        <translation>Log-likelihood ratio of growth against the learned floor that makes an onset (onset_test.h)</translation>
    </message>
    <message>
        <source>Chatter ratio</source>
        <translation>Chatter ratio</translation>
    </message>
    <message>
        <source>Energy ratio from which a cut is in full chatter</source>
        <translation>Energy ratio from which a cut is in full chatter</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Window</translation>
    </message>
    <message>
        <source>Length of the spectrum; auto: 28 turns, at most 1.5 s (paper: 0.512 s)</source>
        <translation>Length of the spectrum; auto: 28 turns, at most 1.5 s (paper: 0.512 s)</translation>
    </message>
    <message>
        <source>Spectra per window</source>
        <translation>Spectra per window</translation>
    </message>
    <message>
        <source>A new spectrum is taken this often within one window</source>
        <translation>A new spectrum is taken this often within one window</translation>
    </message>
    <message>
        <source>Line threshold</source>
        <translation>Line threshold</translation>
    </message>
    <message>
        <source>Amplitude (unit of the sensor) of a line that is chatter; auto: growth above the learned floor</source>
        <translation>Amplitude (unit of the sensor) of a line that is chatter; auto: growth above the learned floor</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Mask</translation>
    </message>
    <message>
        <source>Half width of the mask on a harmonic, in bins</source>
        <translation>Half width of the mask on a harmonic, in bins</translation>
    </message>
    <message>
        <source>Purity</source>
        <translation>Purity</translation>
    </message>
    <message>
        <source>Part of the power between the harmonics that a chatter line holds at least</source>
        <translation>Part of the power between the harmonics that a chatter line holds at least</translation>
    </message>
    <message>
        <source>Spindle harmonics the Kalman filter removes (N, eq. 16); auto: 12 tooth passings, at least 32, as the sampling rate allows</source>
        <translation>Spindle harmonics the Kalman filter removes (N, eq. 16); auto: 12 tooth passings, at least 32, as the sampling rate allows</translation>
    </message>
    <message>
        <source>Process noise ratio</source>
        <translation>Process noise ratio</translation>
    </message>
    <message>
        <source>Q/R of the Kalman filter (eq. 20); auto: a memory of two turns</source>
        <translation>Q/R of the Kalman filter (eq. 20); auto: a memory of two turns</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>Covariance</translation>
    </message>
    <message>
        <source>Covariance of the Kalman filter: its settled gain from the start, or eq. 20 at every sample, which is right from the first turn on and costs some twenty times as much</source>
        <translation>Covariance of the Kalman filter: its settled gain from the start, or eq. 20 at every sample, which is right from the first turn on and costs some twenty times as much</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>settled</translation>
    </message>
    <message>
        <source>full</source>
        <translation>full</translation>
    </message>
    <message>
        <source>Smallest onset</source>
        <translation>Smallest onset</translation>
    </message>
    <message>
        <source>Unrepeated vibration over all vibration (amplitudes) below which growth is not yet called onset</source>
        <translation>Unrepeated vibration over all vibration (amplitudes) below which growth is not yet called onset</translation>
    </message>
    <message>
        <source>Log-likelihood ratio of growth against the learned noise that makes an onset; a stable cut lasts e to this power turns, on average, without a false alarm</source>
        <translation>Log-likelihood ratio of growth against the learned noise that makes an onset; a stable cut lasts e to this power turns, on average, without a false alarm</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Coherence</translation>
    </message>
    <message>
        <source>welch: averaged magnitude-squared coherence; paper: eq. 3-5 of one transform</source>
        <translation>welch: averaged magnitude-squared coherence; paper: eq. 3-5 of one transform</translation>
    </message>
    <message>
        <source>welch</source>
        <translation>welch</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>paper</translation>
    </message>
    <message>
        <source>Sharpening</source>
        <translation>Sharpening</translation>
    </message>
    <message>
        <source>Weighting of the smoothed coherence; printed: eq. 3-17b as it stands</source>
        <translation>Weighting of the smoothed coherence; printed: eq. 3-17b as it stands</translation>
    </message>
    <message>
        <source>monotone</source>
        <translation>monotone</translation>
    </message>
    <message>
        <source>printed</source>
        <translation>printed</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Length of one transform; auto: 12 turns, at most 1 s</source>
        <translation>Length of one transform; auto: 12 turns, at most 1 s</translation>
    </message>
    <message>
        <source>Averages</source>
        <translation>Averages</translation>
    </message>
    <message>
        <source>Memory of the averages, in segments (each overlaps the last by 7/8)</source>
        <translation>Memory of the averages, in segments (each overlaps the last by 7/8)</translation>
    </message>
    <message>
        <source>Window from</source>
        <translation>Window from</translation>
    </message>
    <message>
        <source>Where the window of eq. 3-18 begins to rise (paper: 170 Hz); auto: no window</source>
        <translation>Where the window of eq. 3-18 begins to rise (paper: 170 Hz); auto: no window</translation>
    </message>
    <message>
        <source>Window to</source>
        <translation>Window to</translation>
    </message>
    <message>
        <source>Where the window of eq. 3-18 has fallen (paper: 250 Hz); auto: no window</source>
        <translation>Where the window of eq. 3-18 has fallen (paper: 250 Hz); auto: no window</translation>
    </message>
    <message>
        <source>Coherence reference</source>
        <translation>Coherence reference</translation>
    </message>
    <message>
        <source>gamma_ref: coherence ratio that is chatter's</source>
        <translation>gamma_ref: coherence ratio that is chatter's</translation>
    </message>
    <message>
        <source>Energy reference</source>
        <translation>Energy reference</translation>
    </message>
    <message>
        <source>E_ref (unit of the sensor) of eq. 3-21; auto: growth above the learned floor</source>
        <translation>E_ref (unit of the sensor) of eq. 3-21; auto: growth above the learned floor</translation>
    </message>
    <message>
        <source>Part of the cross spectrum between the harmonics that a chatter line holds at least</source>
        <translation>Part of the cross spectrum between the harmonics that a chatter line holds at least</translation>
    </message>
    <message>
        <source>Confirmation</source>
        <translation>Confirmation</translation>
    </message>
    <message>
        <source>How long an alarm stands at one frequency before the first move</source>
        <translation>How long an alarm stands at one frequency before the first move</translation>
    </message>
    <message>
        <source>Confirmation after a move</source>
        <translation>Confirmation after a move</translation>
    </message>
    <message>
        <source>How long chatter stands at the new speed before that speed is given up</source>
        <translation>How long chatter stands at the new speed before that speed is given up</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Settling</translation>
    </message>
    <message>
        <source>After the spindle has reached a new speed it is judged no sooner</source>
        <translation>After the spindle has reached a new speed it is judged no sooner</translation>
    </message>
    <message>
        <source>Speeds to try</source>
        <translation>Speeds to try</translation>
    </message>
    <message>
        <source>After so many speeds without quiet it goes back and advises only</source>
        <translation>After so many speeds without quiet it goes back and advises only</translation>
    </message>
    <message>
        <source>Memory of tried speeds</source>
        <translation>Memory of tried speeds</translation>
    </message>
    <message>
        <source>After so long without an alarm the tried speeds are forgotten</source>
        <translation>After so long without an alarm the tried speeds are forgotten</translation>
    </message>
    <message>
        <source>Pause after giving up</source>
        <translation>Pause after giving up</translation>
    </message>
    <message>
        <source>So long nothing is tried again after no speed was quiet</source>
        <translation>So long nothing is tried again after no speed was quiet</translation>
    </message>
    <message>
        <source>Smoothing of the frequency</source>
        <translation>Smoothing of the frequency</translation>
    </message>
    <message>
        <source>Time constant of the low-pass on the chatter frequency</source>
        <translation>Time constant of the low-pass on the chatter frequency</translation>
    </message>
    <message>
        <source>Act on</source>
        <translation>Act on</translation>
    </message>
    <message>
        <source>Move at the onset of chatter, or only when it is full chatter</source>
        <translation>Move at the onset of chatter, or only when it is full chatter</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>onset</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>chatter</translation>
    </message>
    <message>
        <source>Freeze when quiet</source>
        <translation>Freeze when quiet</translation>
    </message>
    <message>
        <source>Stay at the actual speed once chatter clears, for narrow lobes, instead of going on to the last target</source>
        <translation>Stay at the actual speed once chatter clears, for narrow lobes, instead of going on to the last target</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>Step size</translation>
    </message>
    <message>
        <source>mu_c of eq. 32</source>
        <translation>mu_c of eq. 32</translation>
    </message>
    <message>
        <source>Smoothing of the level</source>
        <translation>Smoothing of the level</translation>
    </message>
    <message>
        <source>lambda_c of eq. 33</source>
        <translation>lambda_c of eq. 33</translation>
    </message>
    <message>
        <source>Unit of a step</source>
        <translation>Unit of a step</translation>
    </message>
    <message>
        <source>What a step of 1 in eq. 32 is, in percent of the programmed speed</source>
        <translation>What a step of 1 in eq. 32 is, in percent of the programmed speed</translation>
    </message>
    <message>
        <source>Control period</source>
        <translation>Control period</translation>
    </message>
    <message>
        <source>Time from one step of eq. 32 to the next</source>
        <translation>Time from one step of eq. 32 to the next</translation>
    </message>
    <message>
        <source>Step of the search</source>
        <translation>Step of the search</translation>
    </message>
    <message>
        <source>Distance of neighbouring trials, in percent of the programmed speed</source>
        <translation>Distance of neighbouring trials, in percent of the programmed speed</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Speeds to choose from: the nearest, only lower, only higher</source>
        <translation>Speeds to choose from: the nearest, only lower, only higher</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>nearest</translation>
    </message>
    <message>
        <source>down</source>
        <translation>down</translation>
    </message>
    <message>
        <source>up</source>
        <translation>up</translation>
    </message>
    <message>
        <source>Phase factor</source>
        <translation>Phase factor</translation>
    </message>
    <message>
        <source>Fraction of a wave left between two cuts (nu of eq. 3)</source>
        <translation>Fraction of a wave left between two cuts (nu of eq. 3)</translation>
    </message>
    <message>
        <source>Control cycle</source>
        <translation>Control cycle</translation>
    </message>
    <message>
        <source>Speed and feed are changed once per cycle</source>
        <translation>Speed and feed are changed once per cycle</translation>
    </message>
    <message>
        <source>Time for the whole range</source>
        <translation>Time for the whole range</translation>
    </message>
    <message>
        <source>At full output the whole range of an override takes this long (the paper's limit: a second)</source>
        <translation>At full output the whole range of an override takes this long (the paper's limit: a second)</translation>
    </message>
    <message>
        <source>Coherence above which speed and feed fall (gamma_ref)</source>
        <translation>Coherence above which speed and feed fall (gamma_ref)</translation>
    </message>
    <message>
        <source>Vibration over that of the stable cut above which speed and feed fall</source>
        <translation>Vibration over that of the stable cut above which speed and feed fall</translation>
    </message>
    <message>
        <source>Energy limit</source>
        <translation>Energy limit</translation>
    </message>
    <message>
        <source>Vibration over that of the stable cut at which the feed goes to its lowest; at twice that the feed is held</source>
        <translation>Vibration over that of the stable cut at which the feed goes to its lowest; at twice that the feed is held</translation>
    </message>
    <message>
        <source>Highest overrides</source>
        <translation>Highest overrides</translation>
    </message>
    <message>
        <source>Speed and feed rise no further than this share of the programmed values</source>
        <translation>Speed and feed rise no further than this share of the programmed values</translation>
    </message>
    <message>
        <source>Rest of the speed</source>
        <translation>Rest of the speed</translation>
    </message>
    <message>
        <source>The speed does not rise for so long after an alarm</source>
        <translation>The speed does not rise for so long after an alarm</translation>
    </message>
    <message>
        <source>Learning weight</source>
        <translation>Learning weight</translation>
    </message>
    <message>
        <source>Share of the coherence error that the rules learn (w of eq. 3-32)</source>
        <translation>Share of the coherence error that the rules learn (w of eq. 3-32)</translation>
    </message>
    <message>
        <source>Direct tuning</source>
        <translation>Direct tuning</translation>
    </message>
    <message>
        <source>By coherence alone (eq. 3-37) or by coherence and energy (3-36)</source>
        <translation>By coherence alone (eq. 3-37) or by coherence and energy (3-36)</translation>
    </message>
    <message>
        <source>single</source>
        <translation>single</translation>
    </message>
    <message>
        <source>double</source>
        <translation>double</translation>
    </message>
    <message>
        <source>Coherence weight</source>
        <translation>Coherence weight</translation>
    </message>
    <message>
        <source>Weight of the coherence error (w_gamma of eq. 3-34)</source>
        <translation>Weight of the coherence error (w_gamma of eq. 3-34)</translation>
    </message>
    <message>
        <source>Energy weight</source>
        <translation>Energy weight</translation>
    </message>
    <message>
        <source>Weight of the energy error (w_E of eq. 3-35)</source>
        <translation>Weight of the energy error (w_E of eq. 3-35)</translation>
    </message>
    <message>
        <source>Lowest speed override</source>
        <translation>Lowest speed override</translation>
    </message>
    <message>
        <source>Spindle speed is never driven below this share of the programmed speed</source>
        <translation>Spindle speed is never driven below this share of the programmed speed</translation>
    </message>
    <message>
        <source>Highest speed override</source>
        <translation>Highest speed override</translation>
    </message>
    <message>
        <source>Spindle speed is never driven above this share of the programmed speed</source>
        <translation>Spindle speed is never driven above this share of the programmed speed</translation>
    </message>
    <message>
        <source>Lowest feed override</source>
        <translation>Lowest feed override</translation>
    </message>
    <message>
        <source>Feed is never driven below this share of the programmed feed</source>
        <translation>Feed is never driven below this share of the programmed feed</translation>
    </message>
    <message>
        <source>Highest feed override</source>
        <translation>Highest feed override</translation>
    </message>
    <message>
        <source>Feed is never driven above this share of the programmed feed</source>
        <translation>Feed is never driven above this share of the programmed feed</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>Lowest speed</translation>
    </message>
    <message>
        <source>Spindle speed is never driven below this; auto: no such limit</source>
        <translation>Spindle speed is never driven below this; auto: no such limit</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Highest speed</translation>
    </message>
    <message>
        <source>Spindle speed is never driven above this: the machine's limit; auto: none</source>
        <translation>Spindle speed is never driven above this: the machine's limit; auto: none</translation>
    </message>
    <message>
        <source>Highest speed of the tool</source>
        <translation>Highest speed of the tool</translation>
    </message>
    <message>
        <source>What the maker allows the tool; auto: no such limit</source>
        <translation>What the maker allows the tool; auto: no such limit</translation>
    </message>
    <message>
        <source>Highest speed of the holder</source>
        <translation>Highest speed of the holder</translation>
    </message>
    <message>
        <source>What holder and balancing allow; auto: no such limit</source>
        <translation>What holder and balancing allow; auto: no such limit</translation>
    </message>
    <message>
        <source>Highest cutting speed</source>
        <translation>Highest cutting speed</translation>
    </message>
    <message>
        <source>The edge is never driven faster than this; needs the tool's diameter; auto: no such limit</source>
        <translation>The edge is never driven faster than this; needs the tool's diameter; auto: no such limit</translation>
    </message>
    <message>
        <source>Lowest feed</source>
        <translation>Lowest feed</translation>
    </message>
    <message>
        <source>Feed is never driven below this; auto: no such limit</source>
        <translation>Feed is never driven below this; auto: no such limit</translation>
    </message>
    <message>
        <source>Highest feed</source>
        <translation>Highest feed</translation>
    </message>
    <message>
        <source>Feed is never driven above this; auto: no such limit</source>
        <translation>Feed is never driven above this; auto: no such limit</translation>
    </message>
    <message>
        <source>Lowest feed per tooth</source>
        <translation>Lowest feed per tooth</translation>
    </message>
    <message>
        <source>Our overrides never lower the feed per tooth below this share of the programmed one: the edge would rub</source>
        <translation>Our overrides never lower the feed per tooth below this share of the programmed one: the edge would rub</translation>
    </message>
    <message>
        <source>Highest feed per tooth</source>
        <translation>Highest feed per tooth</translation>
    </message>
    <message>
        <source>Our overrides never raise the feed per tooth above this share of the programmed one</source>
        <translation>Our overrides never raise the feed per tooth above this share of the programmed one</translation>
    </message>
    <message>
        <source>Speed change per step</source>
        <translation>Speed change per step</translation>
    </message>
    <message>
        <source>Largest change of the speed override in one step of the gate, in percent of the programmed speed</source>
        <translation>Largest change of the speed override in one step of the gate, in percent of the programmed speed</translation>
    </message>
    <message>
        <source>Speed change per second</source>
        <translation>Speed change per second</translation>
    </message>
    <message>
        <source>Fastest change of the speed override, in percent of the programmed speed per second</source>
        <translation>Fastest change of the speed override, in percent of the programmed speed per second</translation>
    </message>
    <message>
        <source>Feed change per step</source>
        <translation>Feed change per step</translation>
    </message>
    <message>
        <source>Largest change of the feed override in one step of the gate, in percent of the programmed feed</source>
        <translation>Largest change of the feed override in one step of the gate, in percent of the programmed feed</translation>
    </message>
    <message>
        <source>Feed change per second</source>
        <translation>Feed change per second</translation>
    </message>
    <message>
        <source>Fastest change of the feed override, in percent of the programmed feed per second</source>
        <translation>Fastest change of the feed override, in percent of the programmed feed per second</translation>
    </message>
    <message>
        <source>Recovery rate</source>
        <translation>Recovery rate</translation>
    </message>
    <message>
        <source>Rate of the way back toward 100 % when nothing chatters, as a share of the rate away from it</source>
        <translation>Rate of the way back toward 100 % when nothing chatters, as a share of the rate away from it</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Smoothing</translation>
    </message>
    <message>
        <source>Time constant of the low-pass on the wanted overrides</source>
        <translation>Time constant of the low-pass on the wanted overrides</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Dead band</translation>
    </message>
    <message>
        <source>Wanted changes up to this are not worth moving the machine</source>
        <translation>Wanted changes up to this are not worth moving the machine</translation>
    </message>
    <message>
        <source>Changes per minute</source>
        <translation>Changes per minute</translation>
    </message>
    <message>
        <source>Moves that start from rest or turn back, at most so many in any minute</source>
        <translation>Moves that start from rest or turn back, at most so many in any minute</translation>
    </message>
    <message>
        <source>Cool-down</source>
        <translation>Cool-down</translation>
    </message>
    <message>
        <source>Pause after the changes per minute are used up; the second time Auto falls back to Advise</source>
        <translation>Pause after the changes per minute are used up; the second time Auto falls back to Advise</translation>
    </message>
    <message>
        <source>Speed tolerance</source>
        <translation>Speed tolerance</translation>
    </message>
    <message>
        <source>The spindle counts as at speed, and an override as taken, within this</source>
        <translation>The spindle counts as at speed, and an override as taken, within this</translation>
    </message>
    <message>
        <source>Machine state age</source>
        <translation>Machine state age</translation>
    </message>
    <message>
        <source>Verdict age</source>
        <translation>Verdict age</translation>
    </message>
    <message>
        <source>A verdict or request older than this is stale</source>
        <translation>A verdict or request older than this is stale</translation>
    </message>
    <message>
        <source>Hold before release</source>
        <translation>Hold before release</translation>
    </message>
    <message>
        <source>On bad input the overrides are held this long, then the programmed values come back</source>
        <translation>On bad input the overrides are held this long, then the programmed values come back</translation>
    </message>
    <message>
        <source>Rest after release</source>
        <translation>Rest after release</translation>
    </message>
    <message>
        <source>After a release the input must be good for this long before the overrides are taken again</source>
        <translation>After a release the input must be good for this long before the overrides are taken again</translation>
    </message>
    <message>
        <source>Pause after the knob</source>
        <translation>Pause after the knob</translation>
    </message>
    <message>
        <source>After the operator turned a knob nothing new is asked this long</source>
        <translation>After the operator turned a knob nothing new is asked this long</translation>
    </message>
    <message>
        <source>Time to take an override</source>
        <translation>Time to take an override</translation>
    </message>
    <message>
        <source>The override read back must agree with the command within this, or the machine is let go</source>
        <translation>The override read back must agree with the command within this, or the machine is let go</translation>
    </message>
    <message>
        <source>Time for the spindle to follow</source>
        <translation>Time for the spindle to follow</translation>
    </message>
    <message>
        <source>The spindle must reach the commanded speed within this, or the machine is let go</source>
        <translation>The spindle must reach the commanded speed within this, or the machine is let go</translation>
    </message>
    <message>
        <source>Lease</source>
        <translation>Lease</translation>
    </message>
    <message>
        <source>A command that is not renewed within this ends, and the programmed values come back</source>
        <translation>A command that is not renewed within this ends, and the programmed values come back</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Recording</translation>
    </message>
    <message>
        <source>What is kept: everything, what surrounds events, or verdicts and indicators alone</source>
        <translation>What is kept: everything, what surrounds events, or verdicts and indicators alone</translation>
    </message>
    <message>
        <source>continuous</source>
        <translation>continuous</translation>
    </message>
    <message>
        <source>around-events</source>
        <translation>around-events</translation>
    </message>
    <message>
        <source>features</source>
        <translation>features</translation>
    </message>
    <message>
        <source>Kept before an event</source>
        <translation>Kept before an event</translation>
    </message>
    <message>
        <source>Around events: how much is kept from before each</source>
        <translation>Around events: how much is kept from before each</translation>
    </message>
    <message>
        <source>Kept after an event</source>
        <translation>Kept after an event</translation>
    </message>
    <message>
        <source>Around events: how long recording goes on after the last</source>
        <translation>Around events: how long recording goes on after the last</translation>
    </message>
    <message>
        <source>Step of the history</source>
        <translation>Step of the history</translation>
    </message>
    <message>
        <source>Features: one step is kept in so long, and every one with an event</source>
        <translation>Features: one step is kept in so long, and every one with an event</translation>
    </message>
    <message>
        <source>Length of the history</source>
        <translation>Length of the history</translation>
    </message>
    <message>
        <source>Features: what is older goes</source>
        <translation>Features: what is older goes</translation>
    </message>
    <message>
        <source>Keep recordings for</source>
        <translation>Keep recordings for</translation>
    </message>
    <message>
        <source>Older recordings without a marker are deleted when a new one begins</source>
        <translation>Older recordings without a marker are deleted when a new one begins</translation>
    </message>
    <message>
        <source>Keep recordings up to</source>
        <translation>Keep recordings up to</translation>
    </message>
    <message>
        <source>The oldest recordings without a marker are deleted beyond it</source>
        <translation>The oldest recordings without a marker are deleted beyond it</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Feedback</translation>
    </message>
    <message>
        <source>In simulation: what is to fall, vibration by the accelerometers or the force at the spindle's frequency</source>
        <translation>In simulation: what is to fall, vibration by the accelerometers or the force at the spindle's frequency</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>acceleration</translation>
    </message>
    <message>
        <source>force</source>
        <translation>force</translation>
    </message>
    <message>
        <source>Taps</source>
        <translation>Taps</translation>
    </message>
    <message>
        <source>Length of the adaptive filter of each axis (Ford 2013 table 3: 35)</source>
        <translation>Length of the adaptive filter of each axis (Ford 2013 table 3: 35)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Step</translation>
    </message>
    <message>
        <source>Adaptation step mu; while 'normalised' is on, as a share of the largest stable step</source>
        <translation>Adaptation step mu; while 'normalised' is on, as a share of the largest stable step</translation>
    </message>
    <message>
        <source>Normalised</source>
        <translation>Normalised</translation>
    </message>
    <message>
        <source>Take the step as a share of the bound that follows the power of the filtered reference</source>
        <translation>Take the step as a share of the bound that follows the power of the filtered reference</translation>
    </message>
    <message>
        <source>Leak</source>
        <translation>Leak</translation>
    </message>
    <message>
        <source>Factor on the weights at each sample (gamma of eq. 2); 1 forgets nothing</source>
        <translation>Factor on the weights at each sample (gamma of eq. 2); 1 forgets nothing</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Reference</translation>
    </message>
    <message>
        <source>What the filter works from: the error itself, or the disturbance as the model sees it</source>
        <translation>What the filter works from: the error itself, or the disturbance as the model sees it</translation>
    </message>
    <message>
        <source>error</source>
        <translation>error</translation>
    </message>
    <message>
        <source>internal-model</source>
        <translation>internal-model</translation>
    </message>
    <message>
        <source>Path taps</source>
        <translation>Path taps</translation>
    </message>
    <message>
        <source>Length of each part of the recursive model from actuator to sensor (table 3: 35)</source>
        <translation>Length of each part of the recursive model from actuator to sensor (table 3: 35)</translation>
    </message>
    <message>
        <source>Parametric</source>
        <translation>Parametric</translation>
    </message>
    <message>
        <source>Spectral line</source>
        <translation>Spectral line</translation>
    </message>
    <message>
        <source>Energy ratio</source>
        <translation>Energy ratio</translation>
    </message>
    <message>
        <source>Monitoring only</source>
        <translation>Monitoring only</translation>
    </message>
    <message>
        <source>Next stable pocket, checked</source>
        <translation>Next stable pocket, checked</translation>
    </message>
    <message>
        <source>Centre of the lobe</source>
        <translation>Centre of the lobe</translation>
    </message>
    <message>
        <source>Toward less vibration</source>
        <translation>Toward less vibration</translation>
    </message>
    <message>
        <source>Least vibration</source>
        <translation>Least vibration</translation>
    </message>
    <message>
        <source>Quarter wave between teeth</source>
        <translation>Quarter wave between teeth</translation>
    </message>
    <message>
        <source>Fuzzy speed and feed</source>
        <translation>Fuzzy speed and feed</translation>
    </message>
    <message>
        <source>Fuzzy, learning its rules</source>
        <translation>Fuzzy, learning its rules</translation>
    </message>
    <message>
        <source>Fuzzy, outputs tuned directly</source>
        <translation>Fuzzy, outputs tuned directly</translation>
    </message>
    <message>
        <source>The control of the simulated mill; the only one that takes commands from a replay</source>
        <translation>The control of the simulated mill; the only one that takes commands from a replay</translation>
    </message>
    <message>
        <source>LinuxCNC through linuxcncrsh and halrmt: host, port, hal_port</source>
        <translation>LinuxCNC through linuxcncrsh and halrmt: host, port, hal_port</translation>
    </message>
    <message>
        <source>GRBL 1.1 or grblHAL on a serial port or a host: device, baud; host, port</source>
        <translation>GRBL 1.1 or grblHAL on a serial port or a host: device, baud; host, port</translation>
    </message>
    <message>
        <source>A spindle drive or PLC by Modbus TCP or RTU: map, a file of registers</source>
        <translation>A spindle drive or PLC by Modbus TCP or RTU: map, a file of registers</translation>
    </message>
    <message>
        <source>Override voltages through a Comedi card: map, a file of calibration tables</source>
        <translation>Override voltages through a Comedi card: map, a file of calibration tables</translation>
    </message>
    <message>
        <source>A simulated cut from a scenario file, in real time or as fast as possible</source>
        <translation>A simulated cut from a scenario file, in real time or as fast as possible</translation>
    </message>
    <message>
        <source>Audio-class: measurement microphones, USB accelerometers, IEPE conditioners: device, rate_hz, bits, inputs</source>
        <translation>Audio-class: measurement microphones, USB accelerometers, IEPE conditioners: device, rate_hz, bits, inputs</translation>
    </message>
    <message>
        <source>Data acquisition cards, NI and many others: device, rate_hz, range, reference, inputs</source>
        <translation>Data acquisition cards, NI and many others: device, rate_hz, range, reference, inputs</translation>
    </message>
    <message>
        <source>Accelerometers of Linux' industrial I/O, here or through iiod: device, rate_hz, uri, inputs, trigger</source>
        <translation>Accelerometers of Linux' industrial I/O, here or through iiod: device, rate_hz, uri, inputs, trigger</translation>
    </message>
    <message>
        <source>A microcontroller on a serial port, binary frames or text lines: device, baud, rate_hz, format</source>
        <translation>A microcontroller on a serial port, binary frames or text lines: device, baud, rate_hz, format</translation>
    </message>
    <message>
        <source>Several of these as one, aligned on the clock of the first: 1_id, 1_channels, 1_delay_ms, 2_id ...</source>
        <translation>Several of these as one, aligned on the clock of the first: 1_id, 1_channels, 1_delay_ms, 2_id ...</translation>
    </message>
    <message>
        <source>A bridge that sends the same over a socket: host, port, rate_hz, format</source>
        <translation>A bridge that sends the same over a socket: host, port, rate_hz, format</translation>
    </message>
    <message>
        <source>Longest time per trial</source>
        <translation>Longest time per trial</translation>
    </message>
    <message>
        <source>The vibration at each trial is averaged no longer than this</source>
        <translation>The vibration at each trial is averaged no longer than this</translation>
    </message>
    <message>
        <source>Revolutions per trial</source>
        <translation>Revolutions per trial</translation>
    </message>
    <message>
        <source>The vibration at each trial is averaged over so many revolutions, or as long as is allowed</source>
        <translation>The vibration at each trial is averaged over so many revolutions, or as long as is allowed</translation>
    </message>
    <message>
        <source>Signal and cut</source>
        <translation>Signal and cut</translation>
    </message>
    <message>
        <source>Limits of the machine</source>
        <translation>Limits of the machine</translation>
    </message>
    <message>
        <source>Active work-holder</source>
        <translation>Active work-holder</translation>
    </message>
    <message>
        <source>Emphasis</source>
        <translation>Emphasis</translation>
    </message>
    <message>
        <source>How much more the error counts on the lines to quieten than elsewhere, as amplitudes; 1: no more</source>
        <translation>How much more the error counts on the lines to quieten than elsewhere, as amplitudes; 1: no more</translation>
    </message>
    <message>
        <source>Width of the emphasis</source>
        <translation>Width of the emphasis</translation>
    </message>
    <message>
        <source>Around each of the lines to quieten</source>
        <translation>Around each of the lines to quieten</translation>
    </message>
    <message>
        <source>Excitation</source>
        <translation>Excitation</translation>
    </message>
    <message>
        <source>What moves the table while its paths are identified</source>
        <translation>What moves the table while its paths are identified</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>noise</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>sweep</translation>
    </message>
    <message>
        <source>Level of identification</source>
        <translation>Level of identification</translation>
    </message>
    <message>
        <source>Rms of the excitation, as a share of the stroke</source>
        <translation>Rms of the excitation, as a share of the stroke</translation>
    </message>
    <message>
        <source>Time of identification</source>
        <translation>Time of identification</translation>
    </message>
    <message>
        <source>Length of the record it is made from</source>
        <translation>Length of the record it is made from</translation>
    </message>
    <message>
        <source>Age of a model</source>
        <translation>Age of a model</translation>
    </message>
    <message>
        <source>An older model of the path is not started with</source>
        <translation>An older model of the path is not started with</translation>
    </message>
    <message>
        <source>Auxiliary noise</source>
        <translation>Auxiliary noise</translation>
    </message>
    <message>
        <source>Rms of the noise that identifies the path anew while it controls, as a share of the stroke; 0: off</source>
        <translation>Rms of the noise that identifies the path anew while it controls, as a share of the stroke; 0: off</translation>
    </message>
    <message>
        <source>Frames of a block</source>
        <translation>Frames of a block</translation>
    </message>
    <message>
        <source>In simulation: how many samples the device takes at a time</source>
        <translation>In simulation: how many samples the device takes at a time</translation>
    </message>
    <message>
        <source>Peak of small</source>
        <translation>Peak of small</translation>
    </message>
    <message>
        <source>Where the coherence error is called small (NS, PS), of its whole range</source>
        <translation>Where the coherence error is called small (NS, PS), of its whole range</translation>
    </message>
    <message>
        <source>Peak of medium</source>
        <translation>Peak of medium</translation>
    </message>
    <message>
        <source>Where the coherence error is called medium (NM, PM)</source>
        <translation>Where the coherence error is called medium (NM, PM)</translation>
    </message>
    <message>
        <source>Peak of big</source>
        <translation>Peak of big</translation>
    </message>
    <message>
        <source>Where the coherence error is called big (NB, PB)</source>
        <translation>Where the coherence error is called big (NB, PB)</translation>
    </message>
    <message>
        <source>Speed rule</source>
        <translation>Speed rule</translation>
    </message>
    <message>
        <source>What this rule asks of the speed: 5 nothing, 1 down and 9 up at full (figure 3.7)</source>
        <translation>What this rule asks of the speed: 5 nothing, 1 down and 9 up at full (figure 3.7)</translation>
    </message>
    <message>
        <source>Feed rule</source>
        <translation>Feed rule</translation>
    </message>
    <message>
        <source>What this rule asks of the feed: 5 nothing, 1 down and 9 up at full (figure 3.8)</source>
        <translation>What this rule asks of the feed: 5 nothing, 1 down and 9 up at full (figure 3.8)</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Hal port</source>
        <translation>Hal port</translation>
    </message>
    <message>
        <source>Hal component port</source>
        <translation>Hal component port</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Adaptive feed</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Password</translation>
    </message>
    <message>
        <source>Control password</source>
        <translation>Control password</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Device</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>Baud</translation>
    </message>
    <message>
        <source>Reports in inches</source>
        <translation>Reports in inches</translation>
    </message>
    <message>
        <source>Ask words</source>
        <translation>Ask words</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Map</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scenario</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
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
        <translation>Block</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Inputs</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Range</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>ground</translation>
    </message>
    <message>
        <source>common</source>
        <translation>common</translation>
    </message>
    <message>
        <source>differential</source>
        <translation>differential</translation>
    </message>
    <message>
        <source>Uri</source>
        <translation>Uri</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>binary</source>
        <translation>binary</translation>
    </message>
    <message>
        <source>text</source>
        <translation>text</translation>
    </message>
    <message>
        <source>Sync</source>
        <translation>Sync</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Counter</translation>
    </message>
    <message>
        <source>none</source>
        <translation>none</translation>
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
        <translation>Instants</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Sample</translation>
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
        <translation>Byte order</translation>
    </message>
    <message>
        <source>little</source>
        <translation>little</translation>
    </message>
    <message>
        <source>big</source>
        <translation>big</translation>
    </message>
    <message>
        <source>Checksum</source>
        <translation>Checksum</translation>
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
        <translation>Counted</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocity</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>displacement</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>sound</translation>
    </message>
    <message>
        <source>current</source>
        <translation>current</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>speed</translation>
    </message>
    <message>
        <source>Machine in inches</source>
        <translation>Machine in inches</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connect</translation>
    </message>
    <message>
        <source>Read the machine</source>
        <translation>Read the machine</translation>
    </message>
    <message>
        <source>Measure the delay</source>
        <translation>Measure the delay</translation>
    </message>
    <message>
        <source>What it can do</source>
        <translation>What it can do</translation>
    </message>
    <message>
        <source>serial port, for 'grbl' or 'modbus'</source>
        <translation>serial port, for 'grbl' or 'modbus'</translation>
    </message>
    <message>
        <source>linuxcncrsh, for 'linuxcnc'</source>
        <translation>linuxcncrsh, for 'linuxcnc'</translation>
    </message>
    <message>
        <source>halrmt, spindle speed for 'linuxcnc'</source>
        <translation>halrmt, spindle speed for 'linuxcnc'</translation>
    </message>
    <message>
        <source>stillcut-hal, watchdog for 'linuxcnc'</source>
        <translation>stillcut-hal, watchdog for 'linuxcnc'</translation>
    </message>
    <message>
        <source>Modbus server, for 'modbus' with a map</source>
        <translation>Modbus server, for 'modbus' with a map</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>marker</translation>
    </message>
    <message>
        <source>needs a label</source>
        <translation>needs a label</translation>
    </message>
    <message>
        <source>type one beside SPAN</source>
        <translation>type one beside SPAN</translation>
    </message>
    <message>
        <source>export</source>
        <translation>export</translation>
    </message>
    <message>
        <source>the recording is still being read</source>
        <translation>the recording is still being read</translation>
    </message>
    <message>
        <source>a moment later</source>
        <translation>a moment later</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>cannot be written</translation>
    </message>
    <message>
        <source>active work-holder</source>
        <translation>active work-holder</translation>
    </message>
    <message>
        <source>the last record is still being worked on</source>
        <translation>the last record is still being worked on</translation>
    </message>
    <message>
        <source>score</source>
        <translation>score</translation>
    </message>
    <message>
        <source>nothing is marked here</source>
        <translation>nothing is marked here</translation>
    </message>
    <message>
        <source>mark true and false alarms first</source>
        <translation>mark true and false alarms first</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>profile</translation>
    </message>
    <message>
        <source>there is no folder to keep it in</source>
        <translation>there is no folder to keep it in</translation>
    </message>
    <message>
        <source>letters and digits</source>
        <translation>letters and digits</translation>
    </message>
    <message>
        <source>cannot be put in force here</source>
        <translation>cannot be put in force here</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>demonstration</translation>
    </message>
    <message>
        <source>cannot run here</source>
        <translation>cannot run here</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>tools</translation>
    </message>
    <message>
        <source>there is no folder to keep them in</source>
        <translation>there is no folder to keep them in</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>samples</translation>
    </message>
    <message>
        <source>the device has stopped</source>
        <translation>the device has stopped</translation>
    </message>
    <message>
        <source>this channel never moves</source>
        <translation>this channel never moves</translation>
    </message>
    <message>
        <source>is the sensor connected?</source>
        <translation>is the sensor connected?</translation>
    </message>
    <message>
        <source>nothing is open</source>
        <translation>nothing is open</translation>
    </message>
    <message>
        <source>replay</source>
        <translation>replay</translation>
    </message>
    <message>
        <source>is no longer there</source>
        <translation>is no longer there</translation>
    </message>
    <message>
        <source>tune</source>
        <translation>tune</translation>
    </message>
    <message>
        <source>there is no profile to keep them in</source>
        <translation>there is no profile to keep them in</translation>
    </message>
    <message>
        <source>start with --profile</source>
        <translation>start with --profile</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>cannot be made</translation>
    </message>
    <message>
        <source>start</source>
        <translation>start</translation>
    </message>
    <message>
        <source>the machine is under our authority</source>
        <translation>the machine is under our authority</translation>
    </message>
    <message>
        <source>set it to Off first</source>
        <translation>set it to Off first</translation>
    </message>
    <message>
        <source>Vibration limit</source>
        <translation>Vibration limit</translation>
    </message>
    <message>
        <source>Vibration (rms, SI unit of the first channel) from which the bar of the operator's page says that it is too much; auto: no limit</source>
        <translation>Vibration (rms, SI unit of the first channel) from which the bar of the operator's page says that it is too much; auto: no limit</translation>
    </message>
    <message>
        <source>%1 answers</source>
        <translation>%1 answers</translation>
    </message>
    <message>
        <source>it answers, but its state is incomplete</source>
        <translation>it answers, but its state is incomplete</translation>
    </message>
    <message>
        <source>the machine is off</source>
        <translation>the machine is off</translation>
    </message>
    <message>
        <source>the machine is in alarm</source>
        <translation>the machine is in alarm</translation>
    </message>
    <message>
        <source>feed held</source>
        <translation>feed held</translation>
    </message>
    <message>
        <source>program running</source>
        <translation>program running</translation>
    </message>
    <message>
        <source>no program running</source>
        <translation>no program running</translation>
    </message>
    <message>
        <source>spindle %1 rev/min, programmed %2</source>
        <translation>spindle %1 rev/min, programmed %2</translation>
    </message>
    <message>
        <source>overrides %1 % speed, %2 % feed</source>
        <translation>overrides %1 % speed, %2 % feed</translation>
    </message>
    <message>
        <source>locked by the program</source>
        <translation>locked by the program</translation>
    </message>
    <message>
        <source>a look takes %1 ms, and what it shows is %2 ms old</source>
        <translation>a look takes %1 ms, and what it shows is %2 ms old</translation>
    </message>
    <message>
        <source>%1 of %2 looks were lost</source>
        <translation>%1 of %2 looks were lost</translation>
    </message>
    <message>
        <source>speed %1 to %2 %, feed %3 to %4 %</source>
        <translation>speed %1 to %2 %, feed %3 to %4 %</translation>
    </message>
    <message>
        <source>the machine goes back by itself when nothing comes from here</source>
        <translation>the machine goes back by itself when nothing comes from here</translation>
    </message>
    <message>
        <source>the machine has no watchdog: if this program dies, the overrides stay</source>
        <translation>the machine has no watchdog: if this program dies, the overrides stay</translation>
    </message>
    <message>
        <source>one knock along %1: '%2' heard most, %3 dB above the next</source>
        <translation>one knock along %1: '%2' heard most, %3 dB above the next</translation>
    </message>
    <message>
        <source>%4 knocks along %1: '%2' heard most, %3 dB above the next</source>
        <translation>%4 knocks along %1: '%2' heard most, %3 dB above the next</translation>
    </message>
    <message>
        <source>it is right</source>
        <translation>it is right</translation>
    </message>
    <message>
        <source>'%1' and '%2' are exchanged</source>
        <translation>'%1' and '%2' are exchanged</translation>
    </message>
    <message>
        <source>A recording, in real time or at another pace: file, pace, rate_hz where the file does not say</source>
        <translation>A recording, in real time or at another pace: file, pace, rate_hz where the file does not say</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Pace</translation>
    </message>
    <message>
        <source>the device counts nothing: a loss of less than 30 ms or three blocks does not show, a longer one after a second or two</source>
        <translation>the device counts nothing: a loss of less than 30 ms or three blocks does not show, a longer one after a second or two</translation>
    </message>
    <message>
        <source>the card is not calibrated, its volts are nominal; comedi_soft_calibrate calibrates it</source>
        <translation>the card is not calibrated, its volts are nominal; comedi_soft_calibrate calibrates it</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>cannot be opened</translation>
    </message>
    <message>
        <source>is it there, and free?</source>
        <translation>is it there, and free?</translation>
    </message>
    <message>
        <source>nothing is sent</source>
        <translation>nothing is sent</translation>
    </message>
    <message>
        <source>does the device stream?</source>
        <translation>does the device stream?</translation>
    </message>
    <message>
        <source>bytes come, and no sample of the [[channels]] is in them</source>
        <translation>bytes come, and no sample of the [[channels]] is in them</translation>
    </message>
    <message>
        <source>are format, sync, sample, checksum, baud and the number of channels those of the sender?</source>
        <translation>are format, sync, sample, checksum, baud and the number of channels those of the sender?</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>does not answer</translation>
    </message>
    <message>
        <source>does not stream</source>
        <translation>does not stream</translation>
    </message>
    <message>
        <source>does not start</source>
        <translation>does not start</translation>
    </message>
    <message>
        <source>has no inputs that stream</source>
        <translation>has no inputs that stream</translation>
    </message>
    <message>
        <source>it may read single values only</source>
        <translation>it may read single values only</translation>
    </message>
    <message>
        <source>it only shares its memory</source>
        <translation>it only shares its memory</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>cannot be read</translation>
    </message>
    <message>
        <source>does not take these settings together</source>
        <translation>does not take these settings together</translation>
    </message>
    <message>
        <source>has not delivered enough in one piece</source>
        <translation>has not delivered enough in one piece</translation>
    </message>
    <message>
        <source>the device</source>
        <translation>the device</translation>
    </message>
    <message>
        <source>%1 (configuration)</source>
        <translation>%1 (configuration)</translation>
    </message>
    <message>
        <source>%1 Hz cannot be heard at %2 samples a second</source>
        <translation>%1 Hz cannot be heard at %2 samples a second</translation>
    </message>
    <message>
        <source>%1 Hz, channels: %2</source>
        <translation>%1 Hz, channels: %2</translation>
    </message>
    <message>
        <source>%1 MB are left</source>
        <translation>%1 MB are left</translation>
    </message>
    <message>
        <source>%1 [[channels]] in the profile</source>
        <translation>%1 [[channels]] in the profile</translation>
    </message>
    <message>
        <source>%1 and %2 frames</source>
        <translation>%1 and %2 frames</translation>
    </message>
    <message>
        <source>%1 at %2: nothing comes any more, the wire is taken up again</source>
        <translation>%1 at %2: nothing comes any more, the wire is taken up again</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 cannot be read</translation>
    </message>
    <message>
        <source>%1 channels, %2 Hz, %3 bits</source>
        <translation>%1 channels, %2 Hz, %3 bits</translation>
    </message>
    <message>
        <source>%1 datasets 58 hold other functions</source>
        <translation>%1 datasets 58 hold other functions</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 days</translation>
    </message>
    <message>
        <source>%1 has no higher voltage</source>
        <translation>%1 has no higher voltage</translation>
    </message>
    <message>
        <source>%1 hours</source>
        <translation>%1 hours</translation>
    </message>
    <message>
        <source>%1 is longer than the file</source>
        <translation>%1 is longer than the file</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 is not a finite number</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 is not a whole number</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 is out of range</translation>
    </message>
    <message>
        <source>%1 is too large for a sample</source>
        <translation>%1 is too large for a sample</translation>
    </message>
    <message>
        <source>%1 mm is no depth</source>
        <translation>%1 mm is no depth</translation>
    </message>
    <message>
        <source>%1 of %2 bytes are there; copy it again</source>
        <translation>%1 of %2 bytes are there; copy it again</translation>
    </message>
    <message>
        <source>%1 rpm is no speed</source>
        <translation>%1 rpm is no speed</translation>
    </message>
    <message>
        <source>%1 rpm is too low for these modes</source>
        <translation>%1 rpm is too low for these modes</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 times</translation>
    </message>
    <message>
        <source>%1 turns the table round</source>
        <translation>%1 turns the table round</translation>
    </message>
    <message>
        <source>%1 unit %2</source>
        <translation>%1 unit %2</translation>
    </message>
    <message>
        <source>%1 would have alarmed %2; before %3</source>
        <translation>%1 would have alarmed %2; before %3</translation>
    </message>
    <message>
        <source>%1, device %2: %3</source>
        <translation>%1, device %2: %3</translation>
    </message>
    <message>
        <source>%1: %2 failed (%3)</source>
        <translation>%1: %2 failed (%3)</translation>
    </message>
    <message>
        <source>%1: a length inside it is wrong</source>
        <translation>%1: a length inside it is wrong</translation>
    </message>
    <message>
        <source>%1: a tone of %2 Hz, %3 % of what is heard; scale %4 ± %5 %6</source>
        <translation>%1: a tone of %2 Hz, %3 % of what is heard; scale %4 ± %5 %6</translation>
    </message>
    <message>
        <source>%1: feed per tooth</source>
        <translation>%1: feed per tooth</translation>
    </message>
    <message>
        <source>%1: is not the device that it was</source>
        <translation>%1: is not the device that it was</translation>
    </message>
    <message>
        <source>%1: path along %2</source>
        <translation>%1: path along %2</translation>
    </message>
    <message>
        <source>%1: path to the accelerometer along %2</source>
        <translation>%1: path to the accelerometer along %2</translation>
    </message>
    <message>
        <source>%1; some devices need a 'trigger'</source>
        <translation>%1; some devices need a 'trigger'</translation>
    </message>
    <message>
        <source>%1; stillcut-cli devices lists what there is</source>
        <translation>%1; stillcut-cli devices lists what there is</translation>
    </message>
    <message>
        <source>%1; the cut before has been stopped</source>
        <translation>%1; the cut before has been stopped</translation>
    </message>
    <message>
        <source>' converts, or stands before what does</source>
        <translation>' converts, or stands before what does</translation>
    </message>
    <message>
        <source>' is a sound server's</source>
        <translation>' is a sound server's</translation>
    </message>
    <message>
        <source>'%1' and '%2' heard it within %3 dB of each other</source>
        <translation>'%1' and '%2' heard it within %3 dB of each other</translation>
    </message>
    <message>
        <source>'%1' cannot be opened</source>
        <translation>'%1' cannot be opened</translation>
    </message>
    <message>
        <source>'%1' cannot be read</source>
        <translation>'%1' cannot be read</translation>
    </message>
    <message>
        <source>'%1' has no other axis beside it</source>
        <translation>'%1' has no other axis beside it</translation>
    </message>
    <message>
        <source>'%1' is missing</source>
        <translation>'%1' is missing</translation>
    </message>
    <message>
        <source>'%1' is neither true nor false</source>
        <translation>'%1' is neither true nor false</translation>
    </message>
    <message>
        <source>'%1' is no delay</source>
        <translation>'%1' is no delay</translation>
    </message>
    <message>
        <source>'%1' is no name for a file</source>
        <translation>'%1' is no name for a file</translation>
    </message>
    <message>
        <source>'%1' is none</source>
        <translation>'%1' is none</translation>
    </message>
    <message>
        <source>'%1' is not KEY=VALUE</source>
        <translation>'%1' is not KEY=VALUE</translation>
    </message>
    <message>
        <source>'%1' is not a choice</source>
        <translation>'%1' is not a choice</translation>
    </message>
    <message>
        <source>'%1' is not a number</source>
        <translation>'%1' is not a number</translation>
    </message>
    <message>
        <source>'%1' is not a time and a speed</source>
        <translation>'%1' is not a time and a speed</translation>
    </message>
    <message>
        <source>'%1' is not known</source>
        <translation>'%1' is not known</translation>
    </message>
    <message>
        <source>'%1' promises more numbers than the file holds</source>
        <translation>'%1' promises more numbers than the file holds</translation>
    </message>
    <message>
        <source>'%1, which may change the rate and mix channels; hw: names the device itself</source>
        <translation>'%1, which may change the rate and mix channels; hw: names the device itself</translation>
    </message>
    <message>
        <source>'%1channels' is %2</source>
        <translation>'%1channels' is %2</translation>
    </message>
    <message>
        <source>'adaptive_feed' needs 'hal_component_port'</source>
        <translation>'adaptive_feed' needs 'hal_component_port'</translation>
    </message>
    <message>
        <source>'device' = '%1'</source>
        <translation>'device' = '%1'</translation>
    </message>
    <message>
        <source>'full_stroke_um' is less</source>
        <translation>'full_stroke_um' is less</translation>
    </message>
    <message>
        <source>'input_x' and 'input_y'</source>
        <translation>'input_x' and 'input_y'</translation>
    </message>
    <message>
        <source>'map' is missing</source>
        <translation>'map' is missing</translation>
    </message>
    <message>
        <source>'output_x' and 'output_y'</source>
        <translation>'output_x' and 'output_y'</translation>
    </message>
    <message>
        <source>'rate_hz' = %1 is not among its rates</source>
        <translation>'rate_hz' = %1 is not among its rates</translation>
    </message>
    <message>
        <source>'rms' must be above 0 and at most 0.3 of the stroke</source>
        <translation>'rms' must be above 0 and at most 0.3 of the stroke</translation>
    </message>
    <message>
        <source>'source.id' is missing</source>
        <translation>'source.id' is missing</translation>
    </message>
    <message>
        <source>'stroke_um' is more than the output can drive</source>
        <translation>'stroke_um' is more than the output can drive</translation>
    </message>
    <message>
        <source>, %1 bits; 'range'</source>
        <translation>, %1 bits; 'range'</translation>
    </message>
    <message>
        <source>, %1 of them marked false</source>
        <translation>, %1 of them marked false</translation>
    </message>
    <message>
        <source>, and could at %1</source>
        <translation>, and could at %1</translation>
    </message>
    <message>
        <source>, or as "1 g"</source>
        <translation>, or as "1 g"</translation>
    </message>
    <message>
        <source>, or as "94 dB"</source>
        <translation>, or as "94 dB"</translation>
    </message>
    <message>
        <source>, or auto</source>
        <translation>, or auto</translation>
    </message>
    <message>
        <source>, up to %1 Hz for one</source>
        <translation>, up to %1 Hz for one</translation>
    </message>
    <message>
        <source>/24 or a larger number</source>
        <translation>/24 or a larger number</translation>
    </message>
    <message>
        <source>0 to %1 ('inputs')</source>
        <translation>0 to %1 ('inputs')</translation>
    </message>
    <message>
        <source>0 to 1000000 rev/min</source>
        <translation>0 to 1000000 rev/min</translation>
    </message>
    <message>
        <source>1 to 32 sensors are needed</source>
        <translation>1 to 32 sensors are needed</translation>
    </message>
    <message>
        <source>1 to 64 channels and a rate above zero were expected</source>
        <translation>1 to 64 channels and a rate above zero were expected</translation>
    </message>
    <message>
        <source>1_id, 1_channels, 1_delay_ms and 1_ with the device's own settings, then 2_</source>
        <translation>1_id, 1_channels, 1_delay_ms and 1_ with the device's own settings, then 2_</translation>
    </message>
    <message>
        <source>: samples are lost again and again</source>
        <translation>: samples are lost again and again</translation>
    </message>
    <message>
        <source>Analog override</source>
        <translation>Analog override</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>Broken pipe</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Connection refused</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>Connection timed out</translation>
    </message>
    <message>
        <source>DEC and IBM formats are not read</source>
        <translation>DEC and IBM formats are not read</translation>
    </message>
    <message>
        <source>Delta_X holds '%1'</source>
        <translation>Delta_X holds '%1'</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Device or resource busy</translation>
    </message>
    <message>
        <source>DynoWare text</source>
        <translation>DynoWare text</translation>
    </message>
    <message>
        <source>FLAC holds at most 8 channels</source>
        <translation>FLAC holds at most 8 channels</translation>
    </message>
    <message>
        <source>Format not recognised.</source>
        <translation>Format not recognised.</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Input/output error</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Is a directory</translation>
    </message>
    <message>
        <source>Kept by the Tune page; stillcut-cli reads it with --config.</source>
        <translation>Kept by the Tune page; stillcut-cli reads it with --config.</translation>
    </message>
    <message>
        <source>LabVIEW Measurement</source>
        <translation>LabVIEW Measurement</translation>
    </message>
    <message>
        <source>LabVIEW measurement text</source>
        <translation>LabVIEW measurement text</translation>
    </message>
    <message>
        <source>Modbus is not part of this build</source>
        <translation>Modbus is not part of this build</translation>
    </message>
    <message>
        <source>Modbus machine</source>
        <translation>Modbus machine</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>No route to host</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>No space left on device</translation>
    </message>
    <message>
        <source>No such</source>
        <translation>No such</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>No such device</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>No such device or address</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>No such file or directory</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Not a directory</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Permission denied</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Read-only file system</translation>
    </message>
    <message>
        <source>Replay: %1</source>
        <translation>Replay: %1</translation>
    </message>
    <message>
        <source>SI units per device unit</source>
        <translation>SI units per device unit</translation>
    </message>
    <message>
        <source>Simulated mill</source>
        <translation>Simulated mill</translation>
    </message>
    <message>
        <source>Stillcut session</source>
        <translation>Stillcut session</translation>
    </message>
    <message>
        <source>Supported file format but file is malformed.</source>
        <translation>Supported file format but file is malformed.</translation>
    </message>
    <message>
        <source>Supported file format but unsupported encoding.</source>
        <translation>Supported file format but unsupported encoding.</translation>
    </message>
    <message>
        <source>System error.</source>
        <translation>System error.</translation>
    </message>
    <message>
        <source>The device is gone; identify again when it is back</source>
        <translation>The device is gone; identify again when it is back</translation>
    </message>
    <message>
        <source>The tools of this shop; the Set up page writes this file.</source>
        <translation>The tools of this shop; the Set up page writes this file.</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Too many open files</translation>
    </message>
    <message>
        <source>[cut] speed_rpm or feed_mm_min is missing</source>
        <translation>[cut] speed_rpm or feed_mm_min is missing</translation>
    </message>
    <message>
        <source>a block has %1 channels</source>
        <translation>a block has %1 channels</translation>
    </message>
    <message>
        <source>a block needs at least one frame</source>
        <translation>a block needs at least one frame</translation>
    </message>
    <message>
        <source>a chain needs 1 to 6 detectors</source>
        <translation>a chain needs 1 to 6 detectors</translation>
    </message>
    <message>
        <source>a chain needs a strategy</source>
        <translation>a chain needs a strategy</translation>
    </message>
    <message>
        <source>a coil or discrete input is one bit</source>
        <translation>a coil or discrete input is one bit</translation>
    </message>
    <message>
        <source>a cutting speed cannot be limited without the tool's diameter</source>
        <translation>a cutting speed cannot be limited without the tool's diameter</translation>
    </message>
    <message>
        <source>a damaged file</source>
        <translation>a damaged file</translation>
    </message>
    <message>
        <source>a damaged or truncated file</source>
        <translation>a damaged or truncated file</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>a device</translation>
    </message>
    <message>
        <source>a finite number was expected</source>
        <translation>a finite number was expected</translation>
    </message>
    <message>
        <source>a gap of %1 s</source>
        <translation>a gap of %1 s</translation>
    </message>
    <message>
        <source>a history of features; detectors need the samples themselves</source>
        <translation>a history of features; detectors need the samples themselves</translation>
    </message>
    <message>
        <source>a line longer than any of this format</source>
        <translation>a line longer than any of this format</translation>
    </message>
    <message>
        <source>a path cannot be taken over while the table moves</source>
        <translation>a path cannot be taken over while the table moves</translation>
    </message>
    <message>
        <source>a quarter of a turn must fit into 512 samples</source>
        <translation>a quarter of a turn must fit into 512 samples</translation>
    </message>
    <message>
        <source>a range is two numbers, lowest and highest</source>
        <translation>a range is two numbers, lowest and highest</translation>
    </message>
    <message>
        <source>a recording of this name is still being written, or was cut off; take another name</source>
        <translation>a recording of this name is still being written, or was cut off; take another name</translation>
    </message>
    <message>
        <source>a run needs a device</source>
        <translation>a run needs a device</translation>
    </message>
    <message>
        <source>a scenario is needed</source>
        <translation>a scenario is needed</translation>
    </message>
    <message>
        <source>a second segment of the measurement begins</source>
        <translation>a second segment of the measurement begins</translation>
    </message>
    <message>
        <source>a sensor needs a name</source>
        <translation>a sensor needs a name</translation>
    </message>
    <message>
        <source>a session, or a recording of any kind that is imported</source>
        <translation>a session, or a recording of any kind that is imported</translation>
    </message>
    <message>
        <source>a simulated or recorded cut may not drive a real machine</source>
        <translation>a simulated or recorded cut may not drive a real machine</translation>
    </message>
    <message>
        <source>a table is missing or has another layout</source>
        <translation>a table is missing or has another layout</translation>
    </message>
    <message>
        <source>a time step above zero was expected</source>
        <translation>a time step above zero was expected</translation>
    </message>
    <message>
        <source>a truncated file</source>
        <translation>a truncated file</translation>
    </message>
    <message>
        <source>a truncated file, or its header is wrong</source>
        <translation>a truncated file, or its header is wrong</translation>
    </message>
    <message>
        <source>a truncated or damaged file</source>
        <translation>a truncated or damaged file</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>a value is out of range</translation>
    </message>
    <message>
        <source>a value must belong to one voltage</source>
        <translation>a value must belong to one voltage</translation>
    </message>
    <message>
        <source>a value was not finite</source>
        <translation>a value was not finite</translation>
    </message>
    <message>
        <source>above 0 and up to 1000 mm</source>
        <translation>above 0 and up to 1000 mm</translation>
    </message>
    <message>
        <source>above 0 and up to 1e6 rpm</source>
        <translation>above 0 and up to 1e6 rpm</translation>
    </message>
    <message>
        <source>active '%1'</source>
        <translation>active '%1'</translation>
    </message>
    <message>
        <source>active 'alsa'</source>
        <translation>active 'alsa'</translation>
    </message>
    <message>
        <source>actuator</source>
        <translation>actuator</translation>
    </message>
    <message>
        <source>all are time, indicators or empty</source>
        <translation>all are time, indicators or empty</translation>
    </message>
    <message>
        <source>allowed: %1 and above</source>
        <translation>allowed: %1 and above</translation>
    </message>
    <message>
        <source>allowed: %1 to %2</source>
        <translation>allowed: %1 to %2</translation>
    </message>
    <message>
        <source>allowed: up to %1</source>
        <translation>allowed: up to %1</translation>
    </message>
    <message>
        <source>an echo is two numbers, delay in ms and gain</source>
        <translation>an echo is two numbers, delay in ms and gain</translation>
    </message>
    <message>
        <source>an echo's delay must lie between 0 and 1 s</source>
        <translation>an echo's delay must lie between 0 and 1 s</translation>
    </message>
    <message>
        <source>analog outputs are not part of this build</source>
        <translation>analog outputs are not part of this build</translation>
    </message>
    <message>
        <source>angles above zero, 360 degrees together</source>
        <translation>angles above zero, 360 degrees together</translation>
    </message>
    <message>
        <source>announces %1 bytes, but its points take %2</source>
        <translation>announces %1 bytes, but its points take %2</translation>
    </message>
    <message>
        <source>announces %1 points, more than the file holds</source>
        <translation>announces %1 points, more than the file holds</translation>
    </message>
    <message>
        <source>are the unit and the register map right?</source>
        <translation>are the unit and the register map right?</translation>
    </message>
    <message>
        <source>as 192.168.1.0/24</source>
        <translation>as 192.168.1.0/24</translation>
    </message>
    <message>
        <source>as many as the device sends, 1 to %1</source>
        <translation>as many as the device sends, 1 to %1</translation>
    </message>
    <message>
        <source>at least %1 samples</source>
        <translation>at least %1 samples</translation>
    </message>
    <message>
        <source>at least one mode is needed</source>
        <translation>at least one mode is needed</translation>
    </message>
    <message>
        <source>at most %1 frequencies above 0, for example 339, 1024</source>
        <translation>at most %1 frequencies above 0, for example 339, 1024</translation>
    </message>
    <message>
        <source>at most %1 modes can be simulated</source>
        <translation>at most %1 modes can be simulated</translation>
    </message>
    <message>
        <source>at most 31, 63 and 511 bytes</source>
        <translation>at most 31, 63 and 511 bytes</translation>
    </message>
    <message>
        <source>at most 8</source>
        <translation>at most 8</translation>
    </message>
    <message>
        <source>at point %1</source>
        <translation>at point %1</translation>
    </message>
    <message>
        <source>axis must be x or y</source>
        <translation>axis must be x or y</translation>
    </message>
    <message>
        <source>binary frames begin with 1 to 8 bytes in hexadecimal, for example AA55</source>
        <translation>binary frames begin with 1 to 8 bytes in hexadecimal, for example AA55</translation>
    </message>
    <message>
        <source>block frames must lie between 1 and 65536</source>
        <translation>block frames must lie between 1 and 65536</translation>
    </message>
    <message>
        <source>blocks of %1 frames are too long</source>
        <translation>blocks of %1 frames are too long</translation>
    </message>
    <message>
        <source>blocks were lost since the record was made</source>
        <translation>blocks were lost since the record was made</translation>
    </message>
    <message>
        <source>blocks were lost, and input and output of this device do not start together</source>
        <translation>blocks were lost, and input and output of this device do not start together</translation>
    </message>
    <message>
        <source>byte order, format, lines, bytes</source>
        <translation>byte order, format, lines, bytes</translation>
    </message>
    <message>
        <source>cannot be decided again</source>
        <translation>cannot be decided again</translation>
    </message>
    <message>
        <source>cannot be drawn so</source>
        <translation>cannot be drawn so</translation>
    </message>
    <message>
        <source>cannot be marked: the journal beside it belongs to another recording, or is in use</source>
        <translation>cannot be marked: the journal beside it belongs to another recording, or is in use</translation>
    </message>
    <message>
        <source>cannot be opened for %1</source>
        <translation>cannot be opened for %1</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>cannot be opened: %1</translation>
    </message>
    <message>
        <source>cannot be recorded</source>
        <translation>cannot be recorded</translation>
    </message>
    <message>
        <source>cannot identify while the table moves</source>
        <translation>cannot identify while the table moves</translation>
    </message>
    <message>
        <source>cannot stream at a rate</source>
        <translation>cannot stream at a rate</translation>
    </message>
    <message>
        <source>channel %1</source>
        <translation>channel %1</translation>
    </message>
    <message>
        <source>channels of one recording are of one length</source>
        <translation>channels of one recording are of one length</translation>
    </message>
    <message>
        <source>channels, block length or rate</source>
        <translation>channels, block length or rate</translation>
    </message>
    <message>
        <source>channels, rate and block length must be known before</source>
        <translation>channels, rate and block length must be known before</translation>
    </message>
    <message>
        <source>check the machine's profile</source>
        <translation>check the machine's profile</translation>
    </message>
    <message>
        <source>choices: %1</source>
        <translation>choices: %1</translation>
    </message>
    <message>
        <source>choices: acceleration, velocity, displacement, sound, force, current, speed</source>
        <translation>choices: acceleration, velocity, displacement, sound, force, current, speed</translation>
    </message>
    <message>
        <source>choices: iepe, ac, dc</source>
        <translation>choices: iepe, ac, dc</translation>
    </message>
    <message>
        <source>choose some with --channel N[,N]</source>
        <translation>choose some with --channel N[,N]</translation>
    </message>
    <message>
        <source>ci value</source>
        <translation>ci value</translation>
    </message>
    <message>
        <source>coil or holding</source>
        <translation>coil or holding</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>column %1</translation>
    </message>
    <message>
        <source>column %1 holds %2</source>
        <translation>column %1 holds %2</translation>
    </message>
    <message>
        <source>conditioner: %1 channels (allowed: 1 to %2)</source>
        <translation>conditioner: %1 channels (allowed: 1 to %2)</translation>
    </message>
    <message>
        <source>conditioner: sampling rate %1 Hz (allowed: 100 to 1000000)</source>
        <translation>conditioner: sampling rate %1 Hz (allowed: 100 to 1000000)</translation>
    </message>
    <message>
        <source>conditioner: the longest block has no frames</source>
        <translation>conditioner: the longest block has no frames</translation>
    </message>
    <message>
        <source>configure with STILLCUT_DESKTOP=ON</source>
        <translation>configure with STILLCUT_DESKTOP=ON</translation>
    </message>
    <message>
        <source>control made the vibration worse</source>
        <translation>control made the vibration worse</translation>
    </message>
    <message>
        <source>convert to CSV instead, or a span without it</source>
        <translation>convert to CSV instead, or a span without it</translation>
    </message>
    <message>
        <source>could not be repaired</source>
        <translation>could not be repaired</translation>
    </message>
    <message>
        <source>cutting coefficients must be finite</source>
        <translation>cutting coefficients must be finite</translation>
    </message>
    <message>
        <source>damping ratio must lie between 0 and 1</source>
        <translation>damping ratio must lie between 0 and 1</translation>
    </message>
    <message>
        <source>dataset %1</source>
        <translation>dataset %1</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>depth</translation>
    </message>
    <message>
        <source>detector</source>
        <translation>detector</translation>
    </message>
    <message>
        <source>device '%1'</source>
        <translation>device '%1'</translation>
    </message>
    <message>
        <source>diameter must be above zero</source>
        <translation>diameter must be above zero</translation>
    </message>
    <message>
        <source>did you mean '%1'?</source>
        <translation>did you mean '%1'?</translation>
    </message>
    <message>
        <source>direction must not be zero</source>
        <translation>direction must not be zero</translation>
    </message>
    <message>
        <source>does not end after its %1 points</source>
        <translation>does not end after its %1 points</translation>
    </message>
    <message>
        <source>does not go once around</source>
        <translation>does not go once around</translation>
    </message>
    <message>
        <source>does not hold 100 %</source>
        <translation>does not hold 100 %</translation>
    </message>
    <message>
        <source>does not take the trigger '%1'</source>
        <translation>does not take the trigger '%1'</translation>
    </message>
    <message>
        <source>does not tell its range</source>
        <translation>does not tell its range</translation>
    </message>
    <message>
        <source>does the calibrator run, on this channel, and is the machine quiet?</source>
        <translation>does the calibrator run, on this channel, and is the machine quiet?</translation>
    </message>
    <message>
        <source>duration must lie between 0 and 3600 s</source>
        <translation>duration must lie between 0 and 3600 s</translation>
    </message>
    <message>
        <source>each override has an output of its own</source>
        <translation>each override has an output of its own</translation>
    </message>
    <message>
        <source>ended before the record was whole</source>
        <translation>ended before the record was whole</translation>
    </message>
    <message>
        <source>ends after %1 of %2 frames</source>
        <translation>ends after %1 of %2 frames</translation>
    </message>
    <message>
        <source>ends after %1 of %2 points</source>
        <translation>ends after %1 of %2 points</translation>
    </message>
    <message>
        <source>ends before it begins</source>
        <translation>ends before it begins</translation>
    </message>
    <message>
        <source>ends early</source>
        <translation>ends early</translation>
    </message>
    <message>
        <source>every channel has a time column of its own</source>
        <translation>every channel has a time column of its own</translation>
    </message>
    <message>
        <source>every value must be above zero</source>
        <translation>every value must be above zero</translation>
    </message>
    <message>
        <source>every value would be the offset</source>
        <translation>every value would be the offset</translation>
    </message>
    <message>
        <source>exponent must lie in (0, 1]</source>
        <translation>exponent must lie in (0, 1]</translation>
    </message>
    <message>
        <source>export with one X column</source>
        <translation>export with one X column</translation>
    </message>
    <message>
        <source>feed lag must lie between 0 and 10 s</source>
        <translation>feed lag must lie between 0 and 10 s</translation>
    </message>
    <message>
        <source>feed per tooth must lie between 0 and 10 mm</source>
        <translation>feed per tooth must lie between 0 and 10 mm</translation>
    </message>
    <message>
        <source>feed per tooth must not be negative</source>
        <translation>feed per tooth must not be negative</translation>
    </message>
    <message>
        <source>fits no path</source>
        <translation>fits no path</translation>
    </message>
    <message>
        <source>for example energy-ratio.chatter=0.2</source>
        <translation>for example energy-ratio.chatter=0.2</translation>
    </message>
    <message>
        <source>force feedback needs one per axis</source>
        <translation>force feedback needs one per axis</translation>
    </message>
    <message>
        <source>frame %1 of channel %2 is not a finite number</source>
        <translation>frame %1 of channel %2 is not a finite number</translation>
    </message>
    <message>
        <source>frequency must be above zero</source>
        <translation>frequency must be above zero</translation>
    </message>
    <message>
        <source>from must lie before to, with 1 to 65536 columns</source>
        <translation>from must lie before to, with 1 to 65536 columns</translation>
    </message>
    <message>
        <source>full scale</source>
        <translation>full scale</translation>
    </message>
    <message>
        <source>gain must not be zero</source>
        <translation>gain must not be zero</translation>
    </message>
    <message>
        <source>give --rate HZ to read the rows as evenly spaced</source>
        <translation>give --rate HZ to read the rows as evenly spaced</translation>
    </message>
    <message>
        <source>give --rate HZ to read the samples as evenly spaced</source>
        <translation>give --rate HZ to read the samples as evenly spaced</translation>
    </message>
    <message>
        <source>give it with --rate HZ</source>
        <translation>give it with --rate HZ</translation>
    </message>
    <message>
        <source>give the diameter or set it to auto</source>
        <translation>give the diameter or set it to auto</translation>
    </message>
    <message>
        <source>half a second at most</source>
        <translation>half a second at most</translation>
    </message>
    <message>
        <source>has %1 channels at %2 Hz</source>
        <translation>has %1 channels at %2 Hz</translation>
    </message>
    <message>
        <source>has %1 columns where %2 were expected</source>
        <translation>has %1 columns where %2 were expected</translation>
    </message>
    <message>
        <source>has %1 samples, those before %2</source>
        <translation>has %1 samples, those before %2</translation>
    </message>
    <message>
        <source>has a row of %1 numbers</source>
        <translation>has a row of %1 numbers</translation>
    </message>
    <message>
        <source>has another sampling rate than those before</source>
        <translation>has another sampling rate than those before</translation>
    </message>
    <message>
        <source>has different periods for input and output</source>
        <translation>has different periods for input and output</translation>
    </message>
    <message>
        <source>has fewer than two points</source>
        <translation>has fewer than two points</translation>
    </message>
    <message>
        <source>has more numbers than its %1 points</source>
        <translation>has more numbers than its %1 points</translation>
    </message>
    <message>
        <source>has more than 256 columns</source>
        <translation>has more than 256 columns</translation>
    </message>
    <message>
        <source>has more than 64 channels</source>
        <translation>has more than 64 channels</translation>
    </message>
    <message>
        <source>has no %1 Hz (%2)</source>
        <translation>has no %1 Hz (%2)</translation>
    </message>
    <message>
        <source>has no %1 channels (%2)</source>
        <translation>has no %1 channels (%2)</translation>
    </message>
    <message>
        <source>has no %1 channels ('inputs')</source>
        <translation>has no %1 channels ('inputs')</translation>
    </message>
    <message>
        <source>has no active work-holder</source>
        <translation>has no active work-holder</translation>
    </message>
    <message>
        <source>has no channel %1</source>
        <translation>has no channel %1</translation>
    </message>
    <message>
        <source>has no column '%1'</source>
        <translation>has no column '%1'</translation>
    </message>
    <message>
        <source>has no end</source>
        <translation>has no end</translation>
    </message>
    <message>
        <source>has no input %1 ('inputs')</source>
        <translation>has no input %1 ('inputs')</translation>
    </message>
    <message>
        <source>has no marker %1</source>
        <translation>has no marker %1</translation>
    </message>
    <message>
        <source>has no marker '%1'</source>
        <translation>has no marker '%1'</translation>
    </message>
    <message>
        <source>has no range %1 ('range')</source>
        <translation>has no range %1 ('range')</translation>
    </message>
    <message>
        <source>has no samples of %1 bits ('bits')</source>
        <translation>has no samples of %1 bits ('bits')</translation>
    </message>
    <message>
        <source>has no samples of 32 bits (%1)</source>
        <translation>has no samples of 32 bits (%1)</translation>
    </message>
    <message>
        <source>has the channel of 'speed'</source>
        <translation>has the channel of 'speed'</translation>
    </message>
    <message>
        <source>header inconsistent</source>
        <translation>header inconsistent</translation>
    </message>
    <message>
        <source>helix angle (straight teeth assumed)</source>
        <translation>helix angle (straight teeth assumed)</translation>
    </message>
    <message>
        <source>helix must lie within 80 degrees</source>
        <translation>helix must lie within 80 degrees</translation>
    </message>
    <message>
        <source>helix slices must lie between 1 and 200</source>
        <translation>helix slices must lie between 1 and 200</translation>
    </message>
    <message>
        <source>hold sensor and calibrator still</source>
        <translation>hold sensor and calibrator still</translation>
    </message>
    <message>
        <source>holds %1 data sets in several places</source>
        <translation>holds %1 data sets in several places</translation>
    </message>
    <message>
        <source>holds a row that is not all finite numbers</source>
        <translation>holds a row that is not all finite numbers</translation>
    </message>
    <message>
        <source>holds a value that is not finite</source>
        <translation>holds a value that is not finite</translation>
    </message>
    <message>
        <source>holds bytes that are no text</source>
        <translation>holds bytes that are no text</translation>
    </message>
    <message>
        <source>holds fewer bytes than it announces</source>
        <translation>holds fewer bytes than it announces</translation>
    </message>
    <message>
        <source>holds more than 4096 channels</source>
        <translation>holds more than 4096 channels</translation>
    </message>
    <message>
        <source>holds more than 4096 objects</source>
        <translation>holds more than 4096 objects</translation>
    </message>
    <message>
        <source>holds more than 4096 variables</source>
        <translation>holds more than 4096 variables</translation>
    </message>
    <message>
        <source>holds no array of samples</source>
        <translation>holds no array of samples</translation>
    </message>
    <message>
        <source>holds no data set of numbers</source>
        <translation>holds no data set of numbers</translation>
    </message>
    <message>
        <source>holds no dataset 58</source>
        <translation>holds no dataset 58</translation>
    </message>
    <message>
        <source>holds no samples</source>
        <translation>holds no samples</translation>
    </message>
    <message>
        <source>holds no speeds</source>
        <translation>holds no speeds</translation>
    </message>
    <message>
        <source>holds no time recording</source>
        <translation>holds no time recording</translation>
    </message>
    <message>
        <source>holds no truth</source>
        <translation>holds no truth</translation>
    </message>
    <message>
        <source>holds no variable that can be read</source>
        <translation>holds no variable that can be read</translation>
    </message>
    <message>
        <source>holds something that is not a finite number</source>
        <translation>holds something that is not a finite number</translation>
    </message>
    <message>
        <source>holds something that is not a text</source>
        <translation>holds something that is not a text</translation>
    </message>
    <message>
        <source>holds times that are not finite</source>
        <translation>holds times that are not finite</translation>
    </message>
    <message>
        <source>identification</source>
        <translation>identification</translation>
    </message>
    <message>
        <source>identify first</source>
        <translation>identify first</translation>
    </message>
    <message>
        <source>identify it again</source>
        <translation>identify it again</translation>
    </message>
    <message>
        <source>identify it first</source>
        <translation>identify it first</translation>
    </message>
    <message>
        <source>input %1 has %2 bits in %3</source>
        <translation>input %1 has %2 bits in %3</translation>
    </message>
    <message>
        <source>input/output error</source>
        <translation>input/output error</translation>
    </message>
    <message>
        <source>install %1 and build again</source>
        <translation>install %1 and build again</translation>
    </message>
    <message>
        <source>install libcomedi-dev and build again</source>
        <translation>install libcomedi-dev and build again</translation>
    </message>
    <message>
        <source>is 0</source>
        <translation>is 0</translation>
    </message>
    <message>
        <source>is 2</source>
        <translation>is 2</translation>
    </message>
    <message>
        <source>is a folder, not a recording</source>
        <translation>is a folder, not a recording</translation>
    </message>
    <message>
        <source>is a session of version %1</source>
        <translation>is a session of version %1</translation>
    </message>
    <message>
        <source>is an HDF5 file, but not a Stillcut session</source>
        <translation>is an HDF5 file, but not a Stillcut session</translation>
    </message>
    <message>
        <source>is being written already</source>
        <translation>is being written already</translation>
    </message>
    <message>
        <source>is cut short: its end is missing</source>
        <translation>is cut short: its end is missing</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>is empty</translation>
    </message>
    <message>
        <source>is given beside 'device'</source>
        <translation>is given beside 'device'</translation>
    </message>
    <message>
        <source>is given beside sensitivity_mv</source>
        <translation>is given beside sensitivity_mv</translation>
    </message>
    <message>
        <source>is halrmt running there?</source>
        <translation>is halrmt running there?</translation>
    </message>
    <message>
        <source>is it connected?</source>
        <translation>is it connected?</translation>
    </message>
    <message>
        <source>is larger than 16 MB: no file of settings</source>
        <translation>is larger than 16 MB: no file of settings</translation>
    </message>
    <message>
        <source>is later than on-line identification looks, %1 samples</source>
        <translation>is later than on-line identification looks, %1 samples</translation>
    </message>
    <message>
        <source>is linuxcncrsh running there?</source>
        <translation>is linuxcncrsh running there?</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>is missing</translation>
    </message>
    <message>
        <source>is missing or no object in JSON</source>
        <translation>is missing or no object in JSON</translation>
    </message>
    <message>
        <source>is missing, and so is 'feed'</source>
        <translation>is missing, and so is 'feed'</translation>
    </message>
    <message>
        <source>is more than 256 addresses</source>
        <translation>is more than 256 addresses</translation>
    </message>
    <message>
        <source>is neither true nor false</source>
        <translation>is neither true nor false</translation>
    </message>
    <message>
        <source>is no MATLAB file of version 5 or 7</source>
        <translation>is no MATLAB file of version 5 or 7</translation>
    </message>
    <message>
        <source>is no MATLAB file of version 5 to 7.3</source>
        <translation>is no MATLAB file of version 5 to 7.3</translation>
    </message>
    <message>
        <source>is no gap of the recording beside it</source>
        <translation>is no gap of the recording beside it</translation>
    </message>
    <message>
        <source>is no lobe case</source>
        <translation>is no lobe case</translation>
    </message>
    <message>
        <source>is no session</source>
        <translation>is no session</translation>
    </message>
    <message>
        <source>is no session file</source>
        <translation>is no session file</translation>
    </message>
    <message>
        <source>is no sound file that can be read</source>
        <translation>is no sound file that can be read</translation>
    </message>
    <message>
        <source>is no subnet</source>
        <translation>is no subnet</translation>
    </message>
    <message>
        <source>is not a choice: '%1'</source>
        <translation>is not a choice: '%1'</translation>
    </message>
    <message>
        <source>is not a finite number</source>
        <translation>is not a finite number</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>is not a number</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>is not a regular file</translation>
    </message>
    <message>
        <source>is not a single value</source>
        <translation>is not a single value</translation>
    </message>
    <message>
        <source>is not a table</source>
        <translation>is not a table</translation>
    </message>
    <message>
        <source>is not a text</source>
        <translation>is not a text</translation>
    </message>
    <message>
        <source>is not a whole number</source>
        <translation>is not a whole number</translation>
    </message>
    <message>
        <source>is not an array of numbers</source>
        <translation>is not an array of numbers</translation>
    </message>
    <message>
        <source>is not an array of rows</source>
        <translation>is not an array of rows</translation>
    </message>
    <message>
        <source>is not an array of tables</source>
        <translation>is not an array of tables</translation>
    </message>
    <message>
        <source>is not an array of texts</source>
        <translation>is not an array of texts</translation>
    </message>
    <message>
        <source>is not at %1</source>
        <translation>is not at %1</translation>
    </message>
    <message>
        <source>is not repaired: the journal beside it does not fit it</source>
        <translation>is not repaired: the journal beside it does not fit it</translation>
    </message>
    <message>
        <source>is not replaced</source>
        <translation>is not replaced</translation>
    </message>
    <message>
        <source>is out of range: %1</source>
        <translation>is out of range: %1</translation>
    </message>
    <message>
        <source>is spindle 0 configured?</source>
        <translation>is spindle 0 configured?</translation>
    </message>
    <message>
        <source>is still being recorded</source>
        <translation>is still being recorded</translation>
    </message>
    <message>
        <source>is stillcut-hal loaded by the machine's HAL file?</source>
        <translation>is stillcut-hal loaded by the machine's HAL file?</translation>
    </message>
    <message>
        <source>is stillcut.hal wired as it came?</source>
        <translation>is stillcut.hal wired as it came?</translation>
    </message>
    <message>
        <source>is stored in pieces of more than 64 MB</source>
        <translation>is stored in pieces of more than 64 MB</translation>
    </message>
    <message>
        <source>is text in UTF-16</source>
        <translation>is text in UTF-16</translation>
    </message>
    <message>
        <source>is the machine on, and the address right?</source>
        <translation>is the machine on, and the address right?</translation>
    </message>
    <message>
        <source>is this a recording?</source>
        <translation>is this a recording?</translation>
    </message>
    <message>
        <source>is this the controller's port, and the baud rate right?</source>
        <translation>is this the controller's port, and the baud rate right?</translation>
    </message>
    <message>
        <source>is true without [write.heartbeat]</source>
        <translation>is true without [write.heartbeat]</translation>
    </message>
    <message>
        <source>is unknown: '%1'</source>
        <translation>is unknown: '%1'</translation>
    </message>
    <message>
        <source>is zero</source>
        <translation>is zero</translation>
    </message>
    <message>
        <source>it begins before the previous one ends</source>
        <translation>it begins before the previous one ends</translation>
    </message>
    <message>
        <source>it ends before it begins</source>
        <translation>it ends before it begins</translation>
    </message>
    <message>
        <source>it goes through stillcut-hal</source>
        <translation>it goes through stillcut-hal</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>it has %1</translation>
    </message>
    <message>
        <source>it has %1, counted from 0</source>
        <translation>it has %1, counted from 0</translation>
    </message>
    <message>
        <source>it has 0 to %1</source>
        <translation>it has 0 to %1</translation>
    </message>
    <message>
        <source>it has changed since it was opened</source>
        <translation>it has changed since it was opened</translation>
    </message>
    <message>
        <source>it has no markers</source>
        <translation>it has no markers</translation>
    </message>
    <message>
        <source>it has, from 0: %1</source>
        <translation>it has, from 0: %1</translation>
    </message>
    <message>
        <source>it is a recorded session; take another name</source>
        <translation>it is a recorded session; take another name</translation>
    </message>
    <message>
        <source>it may be a recording that is damaged; take another name</source>
        <translation>it may be a recording that is damaged; take another name</translation>
    </message>
    <message>
        <source>it must be below %1</source>
        <translation>it must be below %1</translation>
    </message>
    <message>
        <source>it names the file with outputs and calibration tables</source>
        <translation>it names the file with outputs and calibration tables</translation>
    </message>
    <message>
        <source>it names the file with the machine's registers</source>
        <translation>it names the file with the machine's registers</translation>
    </message>
    <message>
        <source>it reads up to version %1</source>
        <translation>it reads up to version %1</translation>
    </message>
    <message>
        <source>it samples at %1</source>
        <translation>it samples at %1</translation>
    </message>
    <message>
        <source>it says teeth and speed</source>
        <translation>it says teeth and speed</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>it was stopped</translation>
    </message>
    <message>
        <source>it would run out between two commands</source>
        <translation>it would run out between two commands</translation>
    </message>
    <message>
        <source>its 58b line is incomplete</source>
        <translation>its 58b line is incomplete</translation>
    </message>
    <message>
        <source>its abscissa start and step are missing</source>
        <translation>its abscissa start and step are missing</translation>
    </message>
    <message>
        <source>its abscissa step is not positive</source>
        <translation>its abscissa step is not positive</translation>
    </message>
    <message>
        <source>its byte count is not a size</source>
        <translation>its byte count is not a size</translation>
    </message>
    <message>
        <source>its byte order is neither 1 (little) nor 2 (big endian)</source>
        <translation>its byte order is neither 1 (little) nor 2 (big endian)</translation>
    </message>
    <message>
        <source>its ends must be finite</source>
        <translation>its ends must be finite</translation>
    </message>
    <message>
        <source>its header ends early</source>
        <translation>its header ends early</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>its header is damaged</translation>
    </message>
    <message>
        <source>its header is missing</source>
        <translation>its header is missing</translation>
    </message>
    <message>
        <source>its header is not 11 lines long</source>
        <translation>its header is not 11 lines long</translation>
    </message>
    <message>
        <source>its header is wrong</source>
        <translation>its header is wrong</translation>
    </message>
    <message>
        <source>its layout is damaged</source>
        <translation>its layout is damaged</translation>
    </message>
    <message>
        <source>its level must be above zero</source>
        <translation>its level must be above zero</translation>
    </message>
    <message>
        <source>its name, as stillcut-cli devices lists it</source>
        <translation>its name, as stillcut-cli devices lists it</translation>
    </message>
    <message>
        <source>its number of points is not a size</source>
        <translation>its number of points is not a size</translation>
    </message>
    <message>
        <source>its numbers are not IEEE 754</source>
        <translation>its numbers are not IEEE 754</translation>
    </message>
    <message>
        <source>its numbers make no sense in the byte order its header gives</source>
        <translation>its numbers make no sense in the byte order its header gives</translation>
    </message>
    <message>
        <source>its ordinate type is none of 2, 4, 5, 6</source>
        <translation>its ordinate type is none of 2, 4, 5, 6</translation>
    </message>
    <message>
        <source>its phase is off by 90 degrees or more, or the sensor does not hear the actuator there</source>
        <translation>its phase is off by 90 degrees or more, or the sensor does not hear the actuator there</translation>
    </message>
    <message>
        <source>its samples are not evenly spaced in time</source>
        <translation>its samples are not evenly spaced in time</translation>
    </message>
    <message>
        <source>its samples lie in another file</source>
        <translation>its samples lie in another file</translation>
    </message>
    <message>
        <source>its samples lie in other data sets</source>
        <translation>its samples lie in other data sets</translation>
    </message>
    <message>
        <source>its size line (record 7) is unreadable</source>
        <translation>its size line (record 7) is unreadable</translation>
    </message>
    <message>
        <source>its times cannot be read</source>
        <translation>its times cannot be read</translation>
    </message>
    <message>
        <source>journals are written as memory has them</source>
        <translation>journals are written as memory has them</translation>
    </message>
    <message>
        <source>knock along %1, hard, with the machine quiet</source>
        <translation>knock along %1, hard, with the machine quiet</translation>
    </message>
    <message>
        <source>knock straight along %1, close to the sensor</source>
        <translation>knock straight along %1, close to the sensor</translation>
    </message>
    <message>
        <source>known: %1</source>
        <translation>known: %1</translation>
    </message>
    <message>
        <source>label, author or note is too long</source>
        <translation>label, author or note is too long</translation>
    </message>
    <message>
        <source>largest depth</source>
        <translation>largest depth</translation>
    </message>
    <message>
        <source>leave it out for the usual value</source>
        <translation>leave it out for the usual value</translation>
    </message>
    <message>
        <source>leaves no room for two words</source>
        <translation>leaves no room for two words</translation>
    </message>
    <message>
        <source>leaves what a machine can do</source>
        <translation>leaves what a machine can do</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>left out: %1</translation>
    </message>
    <message>
        <source>linearise the force at the mean chip thickness first</source>
        <translation>linearise the force at the mean chip thickness first</translation>
    </message>
    <message>
        <source>link</source>
        <translation>link</translation>
    </message>
    <message>
        <source>link '%1'</source>
        <translation>link '%1'</translation>
    </message>
    <message>
        <source>link 'analog'</source>
        <translation>link 'analog'</translation>
    </message>
    <message>
        <source>link 'grbl'</source>
        <translation>link 'grbl'</translation>
    </message>
    <message>
        <source>link 'linuxcnc'</source>
        <translation>link 'linuxcnc'</translation>
    </message>
    <message>
        <source>link 'modbus'</source>
        <translation>link 'modbus'</translation>
    </message>
    <message>
        <source>link 'simulated'</source>
        <translation>link 'simulated'</translation>
    </message>
    <message>
        <source>little and big endian mixed up</source>
        <translation>little and big endian mixed up</translation>
    </message>
    <message>
        <source>mV per g, Pa, N ... of the data sheet</source>
        <translation>mV per g, Pa, N ... of the data sheet</translation>
    </message>
    <message>
        <source>marker '%1'</source>
        <translation>marker '%1'</translation>
    </message>
    <message>
        <source>more than %1 MB</source>
        <translation>more than %1 MB</translation>
    </message>
    <message>
        <source>more than a million speeds</source>
        <translation>more than a million speeds</translation>
    </message>
    <message>
        <source>move %1 away</source>
        <translation>move %1 away</translation>
    </message>
    <message>
        <source>move %1 away to clear the mark of the dead writer alone</source>
        <translation>move %1 away to clear the mark of the dead writer alone</translation>
    </message>
    <message>
        <source>must be a number from %1 to %2</source>
        <translation>must be a number from %1 to %2</translation>
    </message>
    <message>
        <source>must be a number other than zero</source>
        <translation>must be a number other than zero</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>must be a whole number</translation>
    </message>
    <message>
        <source>must be above zero</source>
        <translation>must be above zero</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>must be true or false</translation>
    </message>
    <message>
        <source>must take half a second to a minute</source>
        <translation>must take half a second to a minute</translation>
    </message>
    <message>
        <source>name one of them or their folder: %1</source>
        <translation>name one of them or their folder: %1</translation>
    </message>
    <message>
        <source>name the one to read: FILE:/path</source>
        <translation>name the one to read: FILE:/path</translation>
    </message>
    <message>
        <source>names %1 columns where the rows have %2</source>
        <translation>names %1 columns where the rows have %2</translation>
    </message>
    <message>
        <source>names parted by commas were expected</source>
        <translation>names parted by commas were expected</translation>
    </message>
    <message>
        <source>needs one angle per tooth</source>
        <translation>needs one angle per tooth</translation>
    </message>
    <message>
        <source>needs the numbers t_s and ratio_chatter_to_forced</source>
        <translation>needs the numbers t_s and ratio_chatter_to_forced</translation>
    </message>
    <message>
        <source>neither 'host' nor 'device' is given</source>
        <translation>neither 'host' nor 'device' is given</translation>
    </message>
    <message>
        <source>no GRBL status report</source>
        <translation>no GRBL status report</translation>
    </message>
    <message>
        <source>no accelerometer along %1</source>
        <translation>no accelerometer along %1</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>no answer</translation>
    </message>
    <message>
        <source>no column is a channel</source>
        <translation>no column is a channel</translation>
    </message>
    <message>
        <source>no connection</source>
        <translation>no connection</translation>
    </message>
    <message>
        <source>no dataset 58 in it</source>
        <translation>no dataset 58 in it</translation>
    </message>
    <message>
        <source>no force sensor along %1</source>
        <translation>no force sensor along %1</translation>
    </message>
    <message>
        <source>no model of the path from actuator to sensor</source>
        <translation>no model of the path from actuator to sensor</translation>
    </message>
    <message>
        <source>no rows of numbers found in its first %1 lines</source>
        <translation>no rows of numbers found in its first %1 lines</translation>
    </message>
    <message>
        <source>no spindle speed is given</source>
        <translation>no spindle speed is given</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>no such file</translation>
    </message>
    <message>
        <source>nobody renewed the lease</source>
        <translation>nobody renewed the lease</translation>
    </message>
    <message>
        <source>noise, or a sensor that is not on the table</source>
        <translation>noise, or a sensor that is not on the table</translation>
    </message>
    <message>
        <source>none of its samples is a number</source>
        <translation>none of its samples is a number</translation>
    </message>
    <message>
        <source>none was heard</source>
        <translation>none was heard</translation>
    </message>
    <message>
        <source>not a Stillcut session either</source>
        <translation>not a Stillcut session either</translation>
    </message>
    <message>
        <source>not a readable file</source>
        <translation>not a readable file</translation>
    </message>
    <message>
        <source>not a universal file of measured functions</source>
        <translation>not a universal file of measured functions</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>not at all</translation>
    </message>
    <message>
        <source>nothing is heard</source>
        <translation>nothing is heard</translation>
    </message>
    <message>
        <source>nothing was recorded</source>
        <translation>nothing was recorded</translation>
    </message>
    <message>
        <source>nothing was written to the actuator</source>
        <translation>nothing was written to the actuator</translation>
    </message>
    <message>
        <source>older than %1</source>
        <translation>older than %1</translation>
    </message>
    <message>
        <source>on-line model</source>
        <translation>on-line model</translation>
    </message>
    <message>
        <source>one input from 0 for each of the %1 [[channels]], for example 0,1</source>
        <translation>one input from 0 for each of the %1 [[channels]], for example 0,1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>one of %1</translation>
    </message>
    <message>
        <source>one of them is needed</source>
        <translation>one of them is needed</translation>
    </message>
    <message>
        <source>one of them says it all</source>
        <translation>one of them says it all</translation>
    </message>
    <message>
        <source>one of them says where the machine is</source>
        <translation>one of them says where the machine is</translation>
    </message>
    <message>
        <source>one row of numbers is no recording</source>
        <translation>one row of numbers is no recording</translation>
    </message>
    <message>
        <source>only %1 % of what is heard is a tone near %2 Hz</source>
        <translation>only %1 % of what is heard is a tone near %2 Hz</translation>
    </message>
    <message>
        <source>only HDF5 and MATLAB files have places inside</source>
        <translation>only HDF5 and MATLAB files have places inside</translation>
    </message>
    <message>
        <source>only Stillcut sessions say how they were made</source>
        <translation>only Stillcut sessions say how they were made</translation>
    </message>
    <message>
        <source>only sessions have markers</source>
        <translation>only sessions have markers</translation>
    </message>
    <message>
        <source>open it first</source>
        <translation>open it first</translation>
    </message>
    <message>
        <source>output and reading differ in length</source>
        <translation>output and reading differ in length</translation>
    </message>
    <message>
        <source>path along %1</source>
        <translation>path along %1</translation>
    </message>
    <message>
        <source>path to the force along %1</source>
        <translation>path to the force along %1</translation>
    </message>
    <message>
        <source>peaks reach three times it</source>
        <translation>peaks reach three times it</translation>
    </message>
    <message>
        <source>pitch angles must be above zero</source>
        <translation>pitch angles must be above zero</translation>
    </message>
    <message>
        <source>pitch angles must sum to 360 degrees</source>
        <translation>pitch angles must sum to 360 degrees</translation>
    </message>
    <message>
        <source>pitch needs one angle per tooth</source>
        <translation>pitch needs one angle per tooth</translation>
    </message>
    <message>
        <source>place needs one weight per mode</source>
        <translation>place needs one weight per mode</translation>
    </message>
    <message>
        <source>plughw: in front of it converts them</source>
        <translation>plughw: in front of it converts them</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>point %1</translation>
    </message>
    <message>
        <source>point %1 is not a finite number</source>
        <translation>point %1 is not a finite number</translation>
    </message>
    <message>
        <source>point %1 is not finite</source>
        <translation>point %1 is not finite</translation>
    </message>
    <message>
        <source>process damping (limits at low speed are too low)</source>
        <translation>process damping (limits at low speed are too low)</translation>
    </message>
    <message>
        <source>profile version %1 is newer than this program</source>
        <translation>profile version %1 is newer than this program</translation>
    </message>
    <message>
        <source>promises more samples than the file holds</source>
        <translation>promises more samples than the file holds</translation>
    </message>
    <message>
        <source>put names that hold the delimiter in quotes</source>
        <translation>put names that hold the delimiter in quotes</translation>
    </message>
    <message>
        <source>quantity or scale is missing or senseless</source>
        <translation>quantity or scale is missing or senseless</translation>
    </message>
    <message>
        <source>radial immersion must lie in (0, 1]</source>
        <translation>radial immersion must lie in (0, 1]</translation>
    </message>
    <message>
        <source>ramps must be above zero and at most ten seconds</source>
        <translation>ramps must be above zero and at most ten seconds</translation>
    </message>
    <message>
        <source>random force must lie between 0 and 1000 N/sqrt(Hz)</source>
        <translation>random force must lie between 0 and 1000 N/sqrt(Hz)</translation>
    </message>
    <message>
        <source>rate must lie between 10 Hz and 1 MHz</source>
        <translation>rate must lie between 10 Hz and 1 MHz</translation>
    </message>
    <message>
        <source>recording failed while %1</source>
        <translation>recording failed while %1</translation>
    </message>
    <message>
        <source>recording stopped: the disk is nearly full</source>
        <translation>recording stopped: the disk is nearly full</translation>
    </message>
    <message>
        <source>recording stopped: the file was deleted or moved away</source>
        <translation>recording stopped: the file was deleted or moved away</translation>
    </message>
    <message>
        <source>remove the list where it belongs to another file</source>
        <translation>remove the list where it belongs to another file</translation>
    </message>
    <message>
        <source>rms in %1</source>
        <translation>rms in %1</translation>
    </message>
    <message>
        <source>runout must be finite</source>
        <translation>runout must be finite</translation>
    </message>
    <message>
        <source>runout needs one value per tooth</source>
        <translation>runout needs one value per tooth</translation>
    </message>
    <message>
        <source>sample %1 of '%2'</source>
        <translation>sample %1 of '%2'</translation>
    </message>
    <message>
        <source>samples a second, from 100 to 1000000</source>
        <translation>samples a second, from 100 to 1000000</translation>
    </message>
    <message>
        <source>samples a second, one of the device's</source>
        <translation>samples a second, one of the device's</translation>
    </message>
    <message>
        <source>save each segment as a file of its own</source>
        <translation>save each segment as a file of its own</translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>save it as UTF-8</translation>
    </message>
    <message>
        <source>say which one it should lie along</source>
        <translation>say which one it should lie along</translation>
    </message>
    <message>
        <source>see gate.highest-feed</source>
        <translation>see gate.highest-feed</translation>
    </message>
    <message>
        <source>see gate.highest-speed, gate.tool-highest-speed, gate.holder-highest-speed and gate.highest-cutting-speed</source>
        <translation>see gate.highest-speed, gate.tool-highest-speed, gate.holder-highest-speed and gate.highest-cutting-speed</translation>
    </message>
    <message>
        <source>semi-discretization needs 1 to 2000 cells a tooth period</source>
        <translation>semi-discretization needs 1 to 2000 cells a tooth period</translation>
    </message>
    <message>
        <source>serial ports are not part of this build</source>
        <translation>serial ports are not part of this build</translation>
    </message>
    <message>
        <source>set [device] subdevice</source>
        <translation>set [device] subdevice</translation>
    </message>
    <message>
        <source>set its gain lower</source>
        <translation>set its gain lower</translation>
    </message>
    <message>
        <source>set-up</source>
        <translation>set-up</translation>
    </message>
    <message>
        <source>setting the length</source>
        <translation>setting the length</translation>
    </message>
    <message>
        <source>simulate a variable pitch instead</source>
        <translation>simulate a variable pitch instead</translation>
    </message>
    <message>
        <source>simulated cut</source>
        <translation>simulated cut</translation>
    </message>
    <message>
        <source>simulated machine</source>
        <translation>simulated machine</translation>
    </message>
    <message>
        <source>simulated source</source>
        <translation>simulated source</translation>
    </message>
    <message>
        <source>simulated: %1</source>
        <translation>simulated: %1</translation>
    </message>
    <message>
        <source>sound file</source>
        <translation>sound file</translation>
    </message>
    <message>
        <source>source</source>
        <translation>source</translation>
    </message>
    <message>
        <source>source 'alsa'</source>
        <translation>source 'alsa'</translation>
    </message>
    <message>
        <source>source 'comedi'</source>
        <translation>source 'comedi'</translation>
    </message>
    <message>
        <source>source 'iio'</source>
        <translation>source 'iio'</translation>
    </message>
    <message>
        <source>source 'joined'</source>
        <translation>source 'joined'</translation>
    </message>
    <message>
        <source>source 'replay'</source>
        <translation>source 'replay'</translation>
    </message>
    <message>
        <source>source 'serial'</source>
        <translation>source 'serial'</translation>
    </message>
    <message>
        <source>source 'simulated'</source>
        <translation>source 'simulated'</translation>
    </message>
    <message>
        <source>source 'tcp'</source>
        <translation>source 'tcp'</translation>
    </message>
    <message>
        <source>speed must lie between 1 and 200000 rev/min</source>
        <translation>speed must lie between 1 and 200000 rev/min</translation>
    </message>
    <message>
        <source>speeds must be FROM:TO:STEP with 0 &lt; FROM &lt;= TO</source>
        <translation>speeds must be FROM:TO:STEP with 0 &lt; FROM &lt;= TO</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>spindle speed</translation>
    </message>
    <message>
        <source>stability lobes need a force exponent of 1</source>
        <translation>stability lobes need a force exponent of 1</translation>
    </message>
    <message>
        <source>stability lobes need a regular pitch</source>
        <translation>stability lobes need a regular pitch</translation>
    </message>
    <message>
        <source>steps must be 8 to 5000</source>
        <translation>steps must be 8 to 5000</translation>
    </message>
    <message>
        <source>steps per revolution must lie between 0 (automatic) and 1000000</source>
        <translation>steps per revolution must lie between 0 (automatic) and 1000000</translation>
    </message>
    <message>
        <source>stiffness must be above zero</source>
        <translation>stiffness must be above zero</translation>
    </message>
    <message>
        <source>stop it first</source>
        <translation>stop it first</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>stopped</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>strategy</translation>
    </message>
    <message>
        <source>strategy 'active' needs a table [work_holder]</source>
        <translation>strategy 'active' needs a table [work_holder]</translation>
    </message>
    <message>
        <source>subdevice %1 is no analog output</source>
        <translation>subdevice %1 is no analog output</translation>
    </message>
    <message>
        <source>such a machine tells nothing of its program</source>
        <translation>such a machine tells nothing of its program</translation>
    </message>
    <message>
        <source>such devices are not part of this build</source>
        <translation>such devices are not part of this build</translation>
    </message>
    <message>
        <source>switch 'active.auxiliary' off, or take shorter blocks</source>
        <translation>switch 'active.auxiliary' off, or take shorter blocks</translation>
    </message>
    <message>
        <source>t0_s and t1_s must be times, one after the other</source>
        <translation>t0_s and t1_s must be times, one after the other</translation>
    </message>
    <message>
        <source>take a larger step</source>
        <translation>take a larger step</translation>
    </message>
    <message>
        <source>task</source>
        <translation>task</translation>
    </message>
    <message>
        <source>teeth must be 1 to 12, not %1</source>
        <translation>teeth must be 1 to 12, not %1</translation>
    </message>
    <message>
        <source>the HDF5 file cannot be opened</source>
        <translation>the HDF5 file cannot be opened</translation>
    </message>
    <message>
        <source>the [[channels]] are %1 in all, and %2 of them are taken</source>
        <translation>the [[channels]] are %1 in all, and %2 of them are taken</translation>
    </message>
    <message>
        <source>the active table needs one per axis</source>
        <translation>the active table needs one per axis</translation>
    </message>
    <message>
        <source>the actuator was at its end and the vibration grew</source>
        <translation>the actuator was at its end and the vibration grew</translation>
    </message>
    <message>
        <source>the amplitude limit must be above zero</source>
        <translation>the amplitude limit must be above zero</translation>
    </message>
    <message>
        <source>the block does not fit where it is read to</source>
        <translation>the block does not fit where it is read to</translation>
    </message>
    <message>
        <source>the calibrator's level</source>
        <translation>the calibrator's level</translation>
    </message>
    <message>
        <source>the chosen channel has no axis</source>
        <translation>the chosen channel has no axis</translation>
    </message>
    <message>
        <source>the data chunk is missing: a truncated file</source>
        <translation>the data chunk is missing: a truncated file</translation>
    </message>
    <message>
        <source>the delays must rise from 0 or more to at most 10 s</source>
        <translation>the delays must rise from 0 or more to at most 10 s</translation>
    </message>
    <message>
        <source>the detector in charge or its fallback is not among the enabled ones</source>
        <translation>the detector in charge or its fallback is not among the enabled ones</translation>
    </message>
    <message>
        <source>the device does not run</source>
        <translation>the device does not run</translation>
    </message>
    <message>
        <source>the device lost a block</source>
        <translation>the device lost a block</translation>
    </message>
    <message>
        <source>the devices have %1: N_channels says how many are theirs</source>
        <translation>the devices have %1: N_channels says how many are theirs</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>the end</translation>
    </message>
    <message>
        <source>the error sensor stands still</source>
        <translation>the error sensor stands still</translation>
    </message>
    <message>
        <source>the fastest mode swings %1 times between two teeth</source>
        <translation>the fastest mode swings %1 times between two teeth</translation>
    </message>
    <message>
        <source>the feed range must rise from 0 or more to at most 300 %</source>
        <translation>the feed range must rise from 0 or more to at most 300 %</translation>
    </message>
    <message>
        <source>the file is cut off</source>
        <translation>the file is cut off</translation>
    </message>
    <message>
        <source>the file is cut off or its header is wrong</source>
        <translation>the file is cut off or its header is wrong</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>the file is damaged</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>the file is empty</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>the folder cannot be made</translation>
    </message>
    <message>
        <source>the folder cannot be written to</source>
        <translation>the folder cannot be written to</translation>
    </message>
    <message>
        <source>the gear's table must hold [cut] speed_rpm, or there is nothing to go back to</source>
        <translation>the gear's table must hold [cut] speed_rpm, or there is nothing to go back to</translation>
    </message>
    <message>
        <source>the header is not 't,rpm'</source>
        <translation>the header is not 't,rpm'</translation>
    </message>
    <message>
        <source>the header promises %1 bytes of samples, the file holds %2</source>
        <translation>the header promises %1 bytes of samples, the file holds %2</translation>
    </message>
    <message>
        <source>the host cannot be found</source>
        <translation>the host cannot be found</translation>
    </message>
    <message>
        <source>the leak must lie between 0.9 and 1</source>
        <translation>the leak must lie between 0.9 and 1</translation>
    </message>
    <message>
        <source>the lease is shorter than two blocks</source>
        <translation>the lease is shorter than two blocks</translation>
    </message>
    <message>
        <source>the lease must be above zero and at most one second</source>
        <translation>the lease must be above zero and at most one second</translation>
    </message>
    <message>
        <source>the level moves by %1 %</source>
        <translation>the level moves by %1 %</translation>
    </message>
    <message>
        <source>the line is too long</source>
        <translation>the line is too long</translation>
    </message>
    <message>
        <source>the longest was %1 of %2</source>
        <translation>the longest was %1 of %2</translation>
    </message>
    <message>
        <source>the loop diverged</source>
        <translation>the loop diverged</translation>
    </message>
    <message>
        <source>the lowest feed is not below the highest</source>
        <translation>the lowest feed is not below the highest</translation>
    </message>
    <message>
        <source>the lowest speed is not below the highest</source>
        <translation>the lowest speed is not below the highest</translation>
    </message>
    <message>
        <source>the machine's override cannot reach the allowed range</source>
        <translation>the machine's override cannot reach the allowed range</translation>
    </message>
    <message>
        <source>the machine's state is incomplete</source>
        <translation>the machine's state is incomplete</translation>
    </message>
    <message>
        <source>the machine's watchdog was not seen to act</source>
        <translation>the machine's watchdog was not seen to act</translation>
    </message>
    <message>
        <source>the marker cannot be written</source>
        <translation>the marker cannot be written</translation>
    </message>
    <message>
        <source>the markers cannot be read</source>
        <translation>the markers cannot be read</translation>
    </message>
    <message>
        <source>the model along %1 is %2 minutes old</source>
        <translation>the model along %1 is %2 minutes old</translation>
    </message>
    <message>
        <source>the model along %1 promises no stability on the lines to quieten, worst at %2 Hz</source>
        <translation>the model along %1 promises no stability on the lines to quieten, worst at %2 Hz</translation>
    </message>
    <message>
        <source>the nearest is %1</source>
        <translation>the nearest is %1</translation>
    </message>
    <message>
        <source>the number of channels changed</source>
        <translation>the number of channels changed</translation>
    </message>
    <message>
        <source>the order of semi-discretization must be 0 or 1</source>
        <translation>the order of semi-discretization must be 0 or 1</translation>
    </message>
    <message>
        <source>the output does not take the programmed values</source>
        <translation>the output does not take the programmed values</translation>
    </message>
    <message>
        <source>the pace must be above zero</source>
        <translation>the pace must be above zero</translation>
    </message>
    <message>
        <source>the pace must be zero (as fast as possible) or above, with a clock</source>
        <translation>the pace must be zero (as fast as possible) or above, with a clock</translation>
    </message>
    <message>
        <source>the path may be later than its model says; identify it again</source>
        <translation>the path may be later than its model says; identify it again</translation>
    </message>
    <message>
        <source>the path's model has more than %1 taps</source>
        <translation>the path's model has more than %1 taps</translation>
    </message>
    <message>
        <source>the path's model holds a number that is not finite</source>
        <translation>the path's model holds a number that is not finite</translation>
    </message>
    <message>
        <source>the path's model is delayed by more than %1 samples</source>
        <translation>the path's model is delayed by more than %1 samples</translation>
    </message>
    <message>
        <source>the path's model is unstable</source>
        <translation>the path's model is unstable</translation>
    </message>
    <message>
        <source>the path's model says that the actuator does nothing</source>
        <translation>the path's model says that the actuator does nothing</translation>
    </message>
    <message>
        <source>the paths are being identified</source>
        <translation>the paths are being identified</translation>
    </message>
    <message>
        <source>the profile's has %1</source>
        <translation>the profile's has %1</translation>
    </message>
    <message>
        <source>the programmed speed is outside the speed table</source>
        <translation>the programmed speed is outside the speed table</translation>
    </message>
    <message>
        <source>the programmed value must be reachable</source>
        <translation>the programmed value must be reachable</translation>
    </message>
    <message>
        <source>the range of the feed override is empty</source>
        <translation>the range of the feed override is empty</translation>
    </message>
    <message>
        <source>the range of the speed override is empty</source>
        <translation>the range of the speed override is empty</translation>
    </message>
    <message>
        <source>the reading does not follow the actuator</source>
        <translation>the reading does not follow the actuator</translation>
    </message>
    <message>
        <source>the registers do not answer</source>
        <translation>the registers do not answer</translation>
    </message>
    <message>
        <source>the repaired file could not be written</source>
        <translation>the repaired file could not be written</translation>
    </message>
    <message>
        <source>the sample rate must be above zero</source>
        <translation>the sample rate must be above zero</translation>
    </message>
    <message>
        <source>the samples are missing</source>
        <translation>the samples are missing</translation>
    </message>
    <message>
        <source>the samples cannot be read</source>
        <translation>the samples cannot be read</translation>
    </message>
    <message>
        <source>the sampling rate is not known: it holds neither a rate nor times</source>
        <translation>the sampling rate is not known: it holds neither a rate nor times</translation>
    </message>
    <message>
        <source>the sampling rate is not known: there is no time column</source>
        <translation>the sampling rate is not known: there is no time column</translation>
    </message>
    <message>
        <source>the sampling rate is senseless</source>
        <translation>the sampling rate is senseless</translation>
    </message>
    <message>
        <source>the sensor read nothing</source>
        <translation>the sensor read nothing</translation>
    </message>
    <message>
        <source>the session file cannot be created</source>
        <translation>the session file cannot be created</translation>
    </message>
    <message>
        <source>the session file cannot be opened</source>
        <translation>the session file cannot be opened</translation>
    </message>
    <message>
        <source>the session file cannot be repaired</source>
        <translation>the session file cannot be repaired</translation>
    </message>
    <message>
        <source>the session file is damaged</source>
        <translation>the session file is damaged</translation>
    </message>
    <message>
        <source>the session file was not closed cleanly</source>
        <translation>the session file was not closed cleanly</translation>
    </message>
    <message>
        <source>the session has others</source>
        <translation>the session has others</translation>
    </message>
    <message>
        <source>the session is closed</source>
        <translation>the session is closed</translation>
    </message>
    <message>
        <source>the setup is missing</source>
        <translation>the setup is missing</translation>
    </message>
    <message>
        <source>the setup is senseless</source>
        <translation>the setup is senseless</translation>
    </message>
    <message>
        <source>the size in its header is wrong, or the file is cut off</source>
        <translation>the size in its header is wrong, or the file is cut off</translation>
    </message>
    <message>
        <source>the slew limit must be above zero</source>
        <translation>the slew limit must be above zero</translation>
    </message>
    <message>
        <source>the span from %1 is empty</source>
        <translation>the span from %1 is empty</translation>
    </message>
    <message>
        <source>the span holds no samples</source>
        <translation>the span holds no samples</translation>
    </message>
    <message>
        <source>the speed must be above zero</source>
        <translation>the speed must be above zero</translation>
    </message>
    <message>
        <source>the speed range is empty</source>
        <translation>the speed range is empty</translation>
    </message>
    <message>
        <source>the speed range must rise from above 0 to at most 300 %</source>
        <translation>the speed range must rise from above 0 to at most 300 %</translation>
    </message>
    <message>
        <source>the step between speeds must be above zero</source>
        <translation>the step between speeds must be above zero</translation>
    </message>
    <message>
        <source>the step must lie between 0 and 1</source>
        <translation>the step must lie between 0 and 1</translation>
    </message>
    <message>
        <source>the table of blocks cannot be read</source>
        <translation>the table of blocks cannot be read</translation>
    </message>
    <message>
        <source>the tangential coefficient must be above zero</source>
        <translation>the tangential coefficient must be above zero</translation>
    </message>
    <message>
        <source>the time column does not grow</source>
        <translation>the time column does not grow</translation>
    </message>
    <message>
        <source>the time does not rise</source>
        <translation>the time does not rise</translation>
    </message>
    <message>
        <source>the time repeats</source>
        <translation>the time repeats</translation>
    </message>
    <message>
        <source>the time runs backwards</source>
        <translation>the time runs backwards</translation>
    </message>
    <message>
        <source>the time steps are uneven</source>
        <translation>the time steps are uneven</translation>
    </message>
    <message>
        <source>the tone is cut off at the input's limit</source>
        <translation>the tone is cut off at the input's limit</translation>
    </message>
    <message>
        <source>the tool has %1 teeth</source>
        <translation>the tool has %1 teeth</translation>
    </message>
    <message>
        <source>the tool's cutting speed lies below the speed range</source>
        <translation>the tool's cutting speed lies below the speed range</translation>
    </message>
    <message>
        <source>the tool's cutting speed must be above zero</source>
        <translation>the tool's cutting speed must be above zero</translation>
    </message>
    <message>
        <source>the value is not a finite number</source>
        <translation>the value is not a finite number</translation>
    </message>
    <message>
        <source>the work-holder needs a flexure with frequency, damping and stiffness</source>
        <translation>the work-holder needs a flexure with frequency, damping and stiffness</translation>
    </message>
    <message>
        <source>the work-holder's filter and amplifier need a bandwidth and a slew limit</source>
        <translation>the work-holder's filter and amplifier need a bandwidth and a slew limit</translation>
    </message>
    <message>
        <source>the work-holder's lines to quieten must be positive frequencies</source>
        <translation>the work-holder's lines to quieten must be positive frequencies</translation>
    </message>
    <message>
        <source>the work-holder's stroke must be above zero and at most 1 mm</source>
        <translation>the work-holder's stroke must be above zero and at most 1 mm</translation>
    </message>
    <message>
        <source>there are: </source>
        <translation>there are: </translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>there are: %1</translation>
    </message>
    <message>
        <source>there is no channel %1</source>
        <translation>there is no channel %1</translation>
    </message>
    <message>
        <source>there is no clock here</source>
        <translation>there is no clock here</translation>
    </message>
    <message>
        <source>there is no plant to drive</source>
        <translation>there is no plant to drive</translation>
    </message>
    <message>
        <source>there is no such array in the file</source>
        <translation>there is no such array in the file</translation>
    </message>
    <message>
        <source>there is no such data set or folder in the file</source>
        <translation>there is no such data set or folder in the file</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>there is no such file</translation>
    </message>
    <message>
        <source>there is no trigger '%1' at %2</source>
        <translation>there is no trigger '%1' at %2</translation>
    </message>
    <message>
        <source>there is no wire to a real device here</source>
        <translation>there is no wire to a real device here</translation>
    </message>
    <message>
        <source>there is no wire to a real machine here</source>
        <translation>there is no wire to a real machine here</translation>
    </message>
    <message>
        <source>there is nothing to exchange it with</source>
        <translation>there is nothing to exchange it with</translation>
    </message>
    <message>
        <source>they must rise</source>
        <translation>they must rise</translation>
    </message>
    <message>
        <source>this HDF5 library cannot repair files</source>
        <translation>this HDF5 library cannot repair files</translation>
    </message>
    <message>
        <source>this is no text recording</source>
        <translation>this is no text recording</translation>
    </message>
    <message>
        <source>this program reads versions %1 to %2</source>
        <translation>this program reads versions %1 to %2</translation>
    </message>
    <message>
        <source>this program was built without alsa-lib</source>
        <translation>this program was built without alsa-lib</translation>
    </message>
    <message>
        <source>this recording cannot be gone back in</source>
        <translation>this recording cannot be gone back in</translation>
    </message>
    <message>
        <source>too large for a sample</source>
        <translation>too large for a sample</translation>
    </message>
    <message>
        <source>too short</source>
        <translation>too short</translation>
    </message>
    <message>
        <source>too short to identify a path from</source>
        <translation>too short to identify a path from</translation>
    </message>
    <message>
        <source>turns too slowly for its rate</source>
        <translation>turns too slowly for its rate</translation>
    </message>
    <message>
        <source>two devices or more are joined: 1_id, 2_id ...</source>
        <translation>two devices or more are joined: 1_id, 2_id ...</translation>
    </message>
    <message>
        <source>two seconds are needed</source>
        <translation>two seconds are needed</translation>
    </message>
    <message>
        <source>two seconds of the tone are needed</source>
        <translation>two seconds of the tone are needed</translation>
    </message>
    <message>
        <source>unevenness must lie between 0 and 0.01 / sqrt(Hz)</source>
        <translation>unevenness must lie between 0 and 0.01 / sqrt(Hz)</translation>
    </message>
    <message>
        <source>universal file, dataset 58</source>
        <translation>universal file, dataset 58</translation>
    </message>
    <message>
        <source>unknown id '%1'</source>
        <translation>unknown id '%1'</translation>
    </message>
    <message>
        <source>unknown key '%1'</source>
        <translation>unknown key '%1'</translation>
    </message>
    <message>
        <source>up to 64 can be read</source>
        <translation>up to 64 can be read</translation>
    </message>
    <message>
        <source>use the link 'simulated'</source>
        <translation>use the link 'simulated'</translation>
    </message>
    <message>
        <source>variable %1</source>
        <translation>variable %1</translation>
    </message>
    <message>
        <source>virtual data sets are not read</source>
        <translation>virtual data sets are not read</translation>
    </message>
    <message>
        <source>volts of one device unit, for example of full scale</source>
        <translation>volts of one device unit, for example of full scale</translation>
    </message>
    <message>
        <source>wait for the end</source>
        <translation>wait for the end</translation>
    </message>
    <message>
        <source>what full scale means must be a number other than 0</source>
        <translation>what full scale means must be a number other than 0</translation>
    </message>
    <message>
        <source>what is there is left as it is</source>
        <translation>what is there is left as it is</translation>
    </message>
    <message>
        <source>what would the machine watch?</source>
        <translation>what would the machine watch?</translation>
    </message>
    <message>
        <source>without it nothing can be told or done</source>
        <translation>without it nothing can be told or done</translation>
    </message>
    <message>
        <source>writing the journal</source>
        <translation>writing the journal</translation>
    </message>
    <message>
        <source>writing to disk</source>
        <translation>writing to disk</translation>
    </message>
    <message>
        <source>x and y are on the same channel</source>
        <translation>x and y are on the same channel</translation>
    </message>
    <message>
        <source>zeroth order averages the force (a tooth cuts %1 % of the time): expect errors of tens of percent between the lobes; the exact method has none</source>
        <translation>zeroth order averages the force (a tooth cuts %1 % of the time): expect errors of tens of percent between the lobes; the exact method has none</translation>
    </message>
    <message>
        <source>zeroth order averages the force although a tooth cuts only %1 % of the time: limits can be far too high, flip lobes and islands are missing; use the exact method</source>
        <translation>zeroth order averages the force although a tooth cuts only %1 % of the time: limits can be far too high, flip lobes and islands are missing; use the exact method</translation>
    </message>
    <message>
        <source>cannot be read as TOML</source>
        <translation>cannot be read as TOML</translation>
    </message>
    <message>
        <source>%1 is above %2 of %3</source>
        <translation>%1 is above %2 of %3</translation>
    </message>
    <message>
        <source>must be above fuzzy.energy-reference</source>
        <translation>must be above fuzzy.energy-reference</translation>
    </message>
    <message>
        <source>rules must fall as coherence rises</source>
        <translation>rules must fall as coherence rises</translation>
    </message>
    <message>
        <source>A machine state older than this is stale; auto: three of the link's own periods and a block</source>
        <translation>A machine state older than this is stale; auto: three of the link's own periods and a block</translation>
    </message>
    <message>
        <source>every machine state would be stale</source>
        <translation>every machine state would be stale</translation>
    </message>
    <message>
        <source>no override could be seen in force in time</source>
        <translation>no override could be seen in force in time</translation>
    </message>
    <message>
        <source>the link reads the machine every %1 ms: at least two of its periods</source>
        <translation>the link reads the machine every %1 ms: at least two of its periods</translation>
    </message>
    <message>
        <source>The run has ended</source>
        <translation>The run has ended</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>as set</translation>
    </message>
    <message>
        <source>a quarter of the told spindle frequency</source>
        <translation>a quarter of the told spindle frequency</translation>
    </message>
    <message>
        <source>low enough for any spindle, as no speed was told</source>
        <translation>low enough for any spindle, as no speed was told</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindle speed</translation>
    </message>
    <message>
        <source>nobody has told it, and the signal has not shown it</source>
        <translation>nobody has told it, and the signal has not shown it</translation>
    </message>
    <message>
        <source>as told</source>
        <translation>as told</translation>
    </message>
    <message>
        <source>as the machine reads it</source>
        <translation>as the machine reads it</translation>
    </message>
    <message>
        <source>found in the signal, and followed</source>
        <translation>found in the signal, and followed</translation>
    </message>
    <message>
        <source>Doubt of the speed</source>
        <translation>Doubt of the speed</translation>
    </message>
    <message>
        <source>no speed is known</source>
        <translation>no speed is known</translation>
    </message>
    <message>
        <source>of what was told</source>
        <translation>of what was told</translation>
    </message>
    <message>
        <source>of what the signal shows</source>
        <translation>of what the signal shows</translation>
    </message>
    <message>
        <source>Noise in air, channel 1</source>
        <translation>Noise in air, channel 1</translation>
    </message>
    <message>
        <source>no air has been heard yet</source>
        <translation>no air has been heard yet</translation>
    </message>
    <message>
        <source>the quietest fifth of a second so far</source>
        <translation>the quietest fifth of a second so far</translation>
    </message>
    <message>
        <source>Noise in air, channel 2</source>
        <translation>Noise in air, channel 2</translation>
    </message>
    <message>
        <source>Noise in air, channel 3</source>
        <translation>Noise in air, channel 3</translation>
    </message>
    <message>
        <source>Noise in air, channel 4</source>
        <translation>Noise in air, channel 4</translation>
    </message>
    <message>
        <source>as many as the working rate hears at this speed</source>
        <translation>as many as the working rate hears at this speed</translation>
    </message>
    <message>
        <source>32, where the forced vibration of most cuts ends</source>
        <translation>32, where the forced vibration of most cuts ends</translation>
    </message>
    <message>
        <source>a memory of two turns at this speed</source>
        <translation>a memory of two turns at this speed</translation>
    </message>
    <message>
        <source>leaves 1 % of each harmonic</source>
        <translation>leaves 1 % of each harmonic</translation>
    </message>
    <message>
        <source>thinned by a whole factor to the paper's 10 kHz or somewhat more</source>
        <translation>thinned by a whole factor to the paper's 10 kHz or somewhat more</translation>
    </message>
    <message>
        <source>the sampling rate itself</source>
        <translation>the sampling rate itself</translation>
    </message>
    <message>
        <source>not yet: it is learned in the steady cut</source>
        <translation>not yet: it is learned in the steady cut</translation>
    </message>
    <message>
        <source>four times the noise floor, or the least growth that counts</source>
        <translation>four times the noise floor, or the least growth that counts</translation>
    </message>
    <message>
        <source>Scale of the signal</source>
        <translation>Scale of the signal</translation>
    </message>
    <message>
        <source>mean of the stable cut so far</source>
        <translation>mean of the stable cut so far</translation>
    </message>
    <message>
        <source>held while an alarm lasts</source>
        <translation>held while an alarm lasts</translation>
    </message>
    <message>
        <source>Noise floor</source>
        <translation>Noise floor</translation>
    </message>
    <message>
        <source>28 turns at the told speed</source>
        <translation>28 turns at the told speed</translation>
    </message>
    <message>
        <source>1.5 s, the most, which 28 turns would exceed</source>
        <translation>1.5 s, the most, which 28 turns would exceed</translation>
    </message>
    <message>
        <source>the paper's, as no speed was told</source>
        <translation>the paper's, as no speed was told</translation>
    </message>
    <message>
        <source>as many as the sampling rate hears at this speed</source>
        <translation>as many as the sampling rate hears at this speed</translation>
    </message>
    <message>
        <source>the least there are, for a tool of few teeth</source>
        <translation>the least there are, for a tool of few teeth</translation>
    </message>
    <message>
        <source>12 tooth passings</source>
        <translation>12 tooth passings</translation>
    </message>
    <message>
        <source>Growth that is an onset</source>
        <translation>Growth that is an onset</translation>
    </message>
    <message>
        <source>four times the noise floor in energy</source>
        <translation>four times the noise floor in energy</translation>
    </message>
    <message>
        <source>the smallest onset, as set, which the noise does not reach</source>
        <translation>the smallest onset, as set, which the noise does not reach</translation>
    </message>
    <message>
        <source>12 turns at the told speed</source>
        <translation>12 turns at the told speed</translation>
    </message>
    <message>
        <source>the paper's, which 12 turns would exceed</source>
        <translation>the paper's, which 12 turns would exceed</translation>
    </message>
    <message>
        <source>12 turns of a slow spindle, as no speed was told</source>
        <translation>12 turns of a slow spindle, as no speed was told</translation>
    </message>
    <message>
        <source>of what changes from turn to turn: four times the noise floor, or the least that counts</source>
        <translation>of what changes from turn to turn: four times the noise floor, or the least that counts</translation>
    </message>
    <message>
        <source>Usual coherence</source>
        <translation>Usual coherence</translation>
    </message>
    <message>
        <source>noise, full scale, step, counts and bandwidth must not be negative</source>
        <translation>noise, full scale, step, counts and bandwidth must not be negative</translation>
    </message>
    <message>
        <source>the torque loop's bandwidth must not be negative</source>
        <translation>the torque loop's bandwidth must not be negative</translation>
    </message>
    <message>
        <source>Energy ratio (eq. 28) from which a cut is in full chatter; more where it is high in the calm cut</source>
        <translation>Energy ratio (eq. 28) from which a cut is in full chatter; more where it is high in the calm cut</translation>
    </message>
    <message>
        <source>Full chatter</source>
        <translation>Full chatter</translation>
    </message>
    <message>
        <source>the chatter ratio, as set</source>
        <translation>the chatter ratio, as set</translation>
    </message>
    <message>
        <source>four times what the channel has in the calm cut</source>
        <translation>four times what the channel has in the calm cut</translation>
    </message>
</context>
<context>
    <name>LobeMarks</name>
    <message>
        <source>now</source>
        <translation>now</translation>
    </message>
    <message>
        <source>advised</source>
        <translation>advised</translation>
    </message>
    <message>
        <source>what if</source>
        <translation>what if</translation>
    </message>
    <message>
        <source>was stable</source>
        <translation>was stable</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>onset</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>chatter</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Operate</source>
        <translation>Operate</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Lobes</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Tune</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sessions</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Set up</translation>
    </message>
</context>
<context>
    <name>PlotFrame</name>
    <message>
        <source>time [s]</source>
        <translation>time [s]</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>Spectrogram of %1 [kHz]</source>
        <translation>Spectrogram of %1 [kHz]</translation>
    </message>
    <message>
        <source>Vibration of %1, rms [%2]</source>
        <translation>Vibration of %1, rms [%2]</translation>
    </message>
    <message>
        <source>Energy ratio, chatter to all</source>
        <translation>Energy ratio, chatter to all</translation>
    </message>
    <message>
        <source>Spindle speed [rpm]</source>
        <translation>Spindle speed [rpm]</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Advise</source>
        <translation>Advise</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Off</translation>
    </message>
    <message>
        <source>the spindle speed is not known</source>
        <translation>the spindle speed is not known</translation>
    </message>
    <message>
        <source>the number of teeth is not known</source>
        <translation>the number of teeth is not known</translation>
    </message>
    <message>
        <source>samples are missing ({0.0} counted)</source>
        <translation>samples are missing ({0.0} counted)</translation>
    </message>
    <message>
        <source>the sensor is at its limit</source>
        <translation>the sensor is at its limit</translation>
    </message>
    <message>
        <source>channel {0.0} delivers values that are not numbers</source>
        <translation>channel {0.0} delivers values that are not numbers</translation>
    </message>
    <message>
        <source>channel {0.0} delivers a constant</source>
        <translation>channel {0.0} delivers a constant</translation>
    </message>
    <message>
        <source>the spindle is running up, {0.0} rpm</source>
        <translation>the spindle is running up, {0.0} rpm</translation>
    </message>
    <message>
        <source>the tool is entering or leaving, {0.2} s</source>
        <translation>the tool is entering or leaving, {0.2} s</translation>
    </message>
    <message>
        <source>energy ratio {0.2} is over {1.2}</source>
        <translation>energy ratio {0.2} is over {1.2}</translation>
    </message>
    <message>
        <source>energy ratio {0.3} grows above its floor of {1.3}</source>
        <translation>energy ratio {0.3} grows above its floor of {1.3}</translation>
    </message>
    <message>
        <source>a line at {2.1} Hz between the harmonics holds {0.3} of the vibration, over {1.3}</source>
        <translation>a line at {2.1} Hz between the harmonics holds {0.3} of the vibration, over {1.3}</translation>
    </message>
    <message>
        <source>vibration that the harmonics leave, {0.3} of all, is over {1.3}, strongest at {2.1} Hz</source>
        <translation>vibration that the harmonics leave, {0.3} of all, is over {1.3}, strongest at {2.1} Hz</translation>
    </message>
    <message>
        <source>coherence ratio {0.2} is over {1.2} at {2.1} Hz and its energy grows</source>
        <translation>coherence ratio {0.2} is over {1.2} at {2.1} Hz and its energy grows</translation>
    </message>
    <message>
        <source>coherence needs two channels, there are {0.0}</source>
        <translation>coherence needs two channels, there are {0.0}</translation>
    </message>
    <message>
        <source>detector {0.0} failed</source>
        <translation>detector {0.0} failed</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>nothing to do</translation>
    </message>
    <message>
        <source>{0.0} rpm puts {1.0} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</source>
        <translation>{0.0} rpm puts {1.0} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</translation>
    </message>
    <message>
        <source>feed follows to {0.0} mm/min, so that each tooth still takes {1.3} mm</source>
        <translation>feed follows to {0.0} mm/min, so that each tooth still takes {1.3} mm</translation>
    </message>
    <message>
        <source>monitoring only</source>
        <translation>monitoring only</translation>
    </message>
    <message>
        <source>there is no usable verdict to act on</source>
        <translation>there is no usable verdict to act on</translation>
    </message>
    <message>
        <source>going back towards {0.2}</source>
        <translation>going back towards {0.2}</translation>
    </message>
    <message>
        <source>{0.0} rpm is already the speed for chatter at {1.0} Hz</source>
        <translation>{0.0} rpm is already the speed for chatter at {1.0} Hz</translation>
    </message>
    <message>
        <source>{0.0} rpm with {1.0} waves between two teeth is in reach, {2.0} rpm is not (chatter {3.0} Hz)</source>
        <translation>{0.0} rpm with {1.0} waves between two teeth is in reach, {2.0} rpm is not (chatter {3.0} Hz)</translation>
    </message>
    <message>
        <source>{0.0} rpm puts {1.2} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</source>
        <translation>{0.0} rpm puts {1.2} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</translation>
    </message>
    <message>
        <source>{0.0} rpm brings a tooth harmonic closer to the chatter, {1.1} Hz apart, level {2.2} of its mean</source>
        <translation>{0.0} rpm brings a tooth harmonic closer to the chatter, {1.1} Hz apart, level {2.2} of its mean</translation>
    </message>
    <message>
        <source>trying {0.0} rpm for less vibration, now {1.4}, best so far {2.4} at {3.0} rpm</source>
        <translation>trying {0.0} rpm for less vibration, now {1.4}, best so far {2.4} at {3.0} rpm</translation>
    </message>
    <message>
        <source>{0.0} rpm vibrates least, {1.4}</source>
        <translation>{0.0} rpm vibrates least, {1.4}</translation>
    </message>
    <message>
        <source>{0.0} rpm lies between the stability limits at {1.0} and {2.0} rpm (chatter {3.0} Hz)</source>
        <translation>{0.0} rpm lies between the stability limits at {1.0} and {2.0} rpm (chatter {3.0} Hz)</translation>
    </message>
    <message>
        <source>no speed in reach is stable at this depth, {1.2} mm at {2.0} rpm would be (chatter {3.0} Hz)</source>
        <translation>no speed in reach is stable at this depth, {1.2} mm at {2.0} rpm would be (chatter {3.0} Hz)</translation>
    </message>
    <message>
        <source>{0.0} speeds tried and none is quiet (chatter {1.0} Hz): take less depth than where it began, {2.0} mm of feed before</source>
        <translation>{0.0} speeds tried and none is quiet (chatter {1.0} Hz): take less depth than where it began, {2.0} mm of feed before</translation>
    </message>
    <message>
        <source>coherence {0.2} and energy {1.1} times that of the stable cut ask for {2.0} rpm and {3.0} mm/min</source>
        <translation>coherence {0.2} and energy {1.1} times that of the stable cut ask for {2.0} rpm and {3.0} mm/min</translation>
    </message>
    <message>
        <source>authority is off</source>
        <translation>authority is off</translation>
    </message>
    <message>
        <source>advice only</source>
        <translation>advice only</translation>
    </message>
    <message>
        <source>the request was not a number</source>
        <translation>the request was not a number</translation>
    </message>
    <message>
        <source>the machine's state is {0.2} s old</source>
        <translation>the machine's state is {0.2} s old</translation>
    </message>
    <message>
        <source>the verdict is {0.2} s old</source>
        <translation>the verdict is {0.2} s old</translation>
    </message>
    <message>
        <source>the machine is not running a program</source>
        <translation>the machine is not running a program</translation>
    </message>
    <message>
        <source>held by the operator</source>
        <translation>held by the operator</translation>
    </message>
    <message>
        <source>waiting for the spindle, {0.0} of {1.0} rpm</source>
        <translation>waiting for the spindle, {0.0} of {1.0} rpm</translation>
    </message>
    <message>
        <source>{0.0} changes in a minute, {1.0} allowed</source>
        <translation>{0.0} changes in a minute, {1.0} allowed</translation>
    </message>
    <message>
        <source>the programmed values are back in force</source>
        <translation>the programmed values are back in force</translation>
    </message>
    <message>
        <source>no fresh command for {0.2} s, programmed values restored</source>
        <translation>no fresh command for {0.2} s, programmed values restored</translation>
    </message>
    <message>
        <source>speed {0.1} % and feed {1.1} %, with the knobs {2.1} % and {3.1} %</source>
        <translation>speed {0.1} % and feed {1.1} %, with the knobs {2.1} % and {3.1} %</translation>
    </message>
    <message>
        <source>speed {0.1} % on its way to {1.1} %, feed {2.1} % to {3.1} %</source>
        <translation>speed {0.1} % on its way to {1.1} %, feed {2.1} % to {3.1} %</translation>
    </message>
    <message>
        <source>what the machine reports makes no sense</source>
        <translation>what the machine reports makes no sense</translation>
    </message>
    <message>
        <source>the overrides have no effect: locked by the program, or at the machine's limit</source>
        <translation>the overrides have no effect: locked by the program, or at the machine's limit</translation>
    </message>
    <message>
        <source>something else controls the overrides</source>
        <translation>something else controls the overrides</translation>
    </message>
    <message>
        <source>the detector's verdict is not usable</source>
        <translation>the detector's verdict is not usable</translation>
    </message>
    <message>
        <source>the request is {0.2} s old</source>
        <translation>the request is {0.2} s old</translation>
    </message>
    <message>
        <source>time stood still, jumped or went back</source>
        <translation>time stood still, jumped or went back</translation>
    </message>
    <message>
        <source>the tool is not in the cut</source>
        <translation>the tool is not in the cut</translation>
    </message>
    <message>
        <source>the feed is on hold</source>
        <translation>the feed is on hold</translation>
    </message>
    <message>
        <source>the operator turns the knobs: speed {0.0} %, feed {1.0} %</source>
        <translation>the operator turns the knobs: speed {0.0} %, feed {1.0} %</translation>
    </message>
    <message>
        <source>the spindle does not follow, {0.0} instead of {1.0} rpm</source>
        <translation>the spindle does not follow, {0.0} instead of {1.0} rpm</translation>
    </message>
    <message>
        <source>the machine does not take the override, {0.1} % instead of {1.1} %</source>
        <translation>the machine does not take the override, {0.1} % instead of {1.1} %</translation>
    </message>
    <message>
        <source>the program went from {0.0} to {1.0} rpm, starting again from 100 %</source>
        <translation>the program went from {0.0} to {1.0} rpm, starting again from 100 %</translation>
    </message>
    <message>
        <source>waiting {0.1} s before taking the overrides again</source>
        <translation>waiting {0.1} s before taking the overrides again</translation>
    </message>
    <message>
        <source>too many changes, waiting {0.0} s</source>
        <translation>too many changes, waiting {0.0} s</translation>
    </message>
    <message>
        <source>Auto is not allowed in this set-up</source>
        <translation>Auto is not allowed in this set-up</translation>
    </message>
    <message>
        <source>more than {0.0} changes in a minute again, advice only from now on</source>
        <translation>more than {0.0} changes in a minute again, advice only from now on</translation>
    </message>
    <message>
        <source>the operator accepted {0.0} rpm and {1.0} mm/min</source>
        <translation>the operator accepted {0.0} rpm and {1.0} mm/min</translation>
    </message>
    <message>
        <source>the operator refused {0.0} rpm and {1.0} mm/min</source>
        <translation>the operator refused {0.0} rpm and {1.0} mm/min</translation>
    </message>
    <message>
        <source>chatter at {0.0} Hz, energy ratio {1.2}</source>
        <translation>chatter at {0.0} Hz, energy ratio {1.2}</translation>
    </message>
    <message>
        <source>quiet again after {0.2} s and {1.1} mm of feed</source>
        <translation>quiet again after {0.2} s and {1.1} mm of feed</translation>
    </message>
    <message>
        <source>authority changed from {0.0} to {1.0}</source>
        <translation>authority changed from {0.0} to {1.0}</translation>
    </message>
    <message>
        <source>back to 100 % at the operator's wish</source>
        <translation>back to 100 % at the operator's wish</translation>
    </message>
    <message>
        <source>the machine has not answered for {0.2} s</source>
        <translation>the machine has not answered for {0.2} s</translation>
    </message>
    <message>
        <source>the machine answers again</source>
        <translation>the machine answers again</translation>
    </message>
    <message>
        <source>recording has stopped</source>
        <translation>recording has stopped</translation>
    </message>
    <message>
        <source>{0.0} blocks were dropped</source>
        <translation>{0.0} blocks were dropped</translation>
    </message>
    <message>
        <source>Auto is granted because this machine is simulated</source>
        <translation>Auto is granted because this machine is simulated</translation>
    </message>
    <message>
        <source>the strategy failed, monitoring only from now on</source>
        <translation>the strategy failed, monitoring only from now on</translation>
    </message>
    <message>
        <source>the advice has changed to {0.0} rpm and {1.0} mm/min, it needs another touch</source>
        <translation>the advice has changed to {0.0} rpm and {1.0} mm/min, it needs another touch</translation>
    </message>
    <message>
        <source>the tool left the cut after {0.2} s and {1.1} mm of feed in chatter</source>
        <translation>the tool left the cut after {0.2} s and {1.1} mm of feed in chatter</translation>
    </message>
    <message>
        <source>channel {0.0} fell silent in the middle of the cut, look for a broken cable</source>
        <translation>channel {0.0} fell silent in the middle of the cut, look for a broken cable</translation>
    </message>
    <message>
        <source>channel {0.0} knocks at any spindle angle, its sensor is loose</source>
        <translation>channel {0.0} knocks at any spindle angle, its sensor is loose</translation>
    </message>
    <message>
        <source>channel {0.0} has left its zero and stands at {1.1}, look at its supply and range</source>
        <translation>channel {0.0} has left its zero and stands at {1.1}, look at its supply and range</translation>
    </message>
    <message>
        <source>most of what channel {0.0} delivers is mains hum of {1.0} Hz, look at its shield and ground</source>
        <translation>most of what channel {0.0} delivers is mains hum of {1.0} Hz, look at its shield and ground</translation>
    </message>
    <message>
        <source>channel {0.0} delivers loud noise and nothing of a cut</source>
        <translation>channel {0.0} delivers loud noise and nothing of a cut</translation>
    </message>
    <message>
        <source>channels {0.0} and {1.0} claim two axes and deliver the same, one of them is wired or named wrongly</source>
        <translation>channels {0.0} and {1.0} claim two axes and deliver the same, one of them is wired or named wrongly</translation>
    </message>
    <message>
        <source>the device delivers {0.1} samples a second instead of {1.1}</source>
        <translation>the device delivers {0.1} samples a second instead of {1.1}</translation>
    </message>
    <message>
        <source>channel {0.0} has a line at {1.1} Hz that moves as order {2.0} folded back, its anti-alias filter is missing</source>
        <translation>channel {0.0} has a line at {1.1} Hz that moves as order {2.0} folded back, its anti-alias filter is missing</translation>
    </message>
    <message>
        <source>still learning, {0.1} s to go</source>
        <translation>still learning, {0.1} s to go</translation>
    </message>
    <message>
        <source>channel {0.0} repeats its values, or comes at another rate than told</source>
        <translation>channel {0.0} repeats its values, or comes at another rate than told</translation>
    </message>
    <message>
        <source>asked for {0.0} %, the limits allow {1.0} %</source>
        <translation>asked for {0.0} %, the limits allow {1.0} %</translation>
    </message>
    <message>
        <source>the machine or its program put the override back to {0.0} %, Stillcut had it at {1.0} %</source>
        <translation>the machine or its program put the override back to {0.0} %, Stillcut had it at {1.0} %</translation>
    </message>
    <message>
        <source>{0.0} lines more than there was room for, the most important were kept</source>
        <translation>{0.0} lines more than there was room for, the most important were kept</translation>
    </message>
    <message>
        <source>{0.0} rpm would help against chatter of {3.0} Hz but the override reaches {1.0} to {2.0} rpm</source>
        <translation>{0.0} rpm would help against chatter of {3.0} Hz but the override reaches {1.0} to {2.0} rpm</translation>
    </message>
    <message>
        <source>quiet, keeping {0.0} rpm that chatter of {1.0} Hz asked for</source>
        <translation>quiet, keeping {0.0} rpm that chatter of {1.0} Hz asked for</translation>
    </message>
    <message>
        <source>monitoring only, at {0.0} rpm and an energy ratio of {1.2}</source>
        <translation>monitoring only, at {0.0} rpm and an energy ratio of {1.2}</translation>
    </message>
    <message>
        <source>nothing to do at {0.0} rpm and an energy ratio of {1.2}</source>
        <translation>nothing to do at {0.0} rpm and an energy ratio of {1.2}</translation>
    </message>
    <message>
        <source>verdict or machine state cannot be acted on, staying at {0.0} rpm</source>
        <translation>verdict or machine state cannot be acted on, staying at {0.0} rpm</translation>
    </message>
    <message>
        <source>the number of teeth is not known, no speed follows from chatter of {0.0} Hz at {1.0} rpm</source>
        <translation>the number of teeth is not known, no speed follows from chatter of {0.0} Hz at {1.0} rpm</translation>
    </message>
    <message>
        <source>a tone of {0.0} Hz fills the signal from its start, chatter or the machine itself</source>
        <translation>a tone of {0.0} Hz fills the signal from its start, chatter or the machine itself</translation>
    </message>
</context>
<context>
    <name>ReportPages</name>
    <message>
        <source>Cut report</source>
        <translation>Cut report</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>page %1 of %2</translation>
    </message>
    <message>
        <source>Alarms and what was done</source>
        <translation>Alarms and what was done</translation>
    </message>
    <message>
        <source>Before: highest until the first command. After: newest at the end of the alarm. Numbers are those in the plots.</source>
        <translation>Before: highest until the first command. After: newest at the end of the alarm. Numbers are those in the plots.</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Events</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>and %1 more</translation>
    </message>
    <message>
        <source>Sensor check</source>
        <translation>Sensor check</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markers</translation>
    </message>
    <message>
        <source>Settings changed during the cut</source>
        <translation>Settings changed during the cut</translation>
    </message>
    <message>
        <source>Settings at the beginning</source>
        <translation>Settings at the beginning</translation>
    </message>
</context>
<context>
    <name>Session</name>
    <message>
        <source>The device is gone; identify again when it is back</source>
        <translation>The device is gone; identify again when it is back</translation>
    </message>
    <message>
        <source>Replay: %1</source>
        <translation>Replay: %1</translation>
    </message>
    <message>
        <source>The run has ended</source>
        <translation>The run has ended</translation>
    </message>
</context>
<context>
    <name>Trial</name>
    <message>
        <source>%1 Hz, channels: %2</source>
        <translation>%1 Hz, channels: %2</translation>
    </message>
    <message>
        <source>%1: a tone of %2 Hz, %3 % of what is heard; scale %4 ± %5 %6</source>
        <translation>%1: a tone of %2 Hz, %3 % of what is heard; scale %4 ± %5 %6</translation>
    </message>
</context>
<context>
    <name>stillcut::ui</name>
    <message>
        <source>%1 rpm, %2</source>
        <translation>%1 rpm, %2</translation>
    </message>
    <message>
        <source>Costs no time</source>
        <translation>Costs no time</translation>
    </message>
    <message>
        <source>Costs %1 time</source>
        <translation>Costs %1 time</translation>
    </message>
    <message>
        <source>Saves %1 time</source>
        <translation>Saves %1 time</translation>
    </message>
    <message>
        <source>cutting speed %1</source>
        <translation>cutting speed %1</translation>
    </message>
    <message>
        <source>The feed stays as it is</source>
        <translation>The feed stays as it is</translation>
    </message>
    <message>
        <source>Feed follows: %1</source>
        <translation>Feed follows: %1</translation>
    </message>
    <message>
        <source>The speed stays as it is</source>
        <translation>The speed stays as it is</translation>
    </message>
    <message>
        <source>ADVICE</source>
        <translation>ADVICE</translation>
    </message>
    <message>
        <source>Back to 100 %</source>
        <translation>Back to 100 %</translation>
    </message>
    <message>
        <source>ASKED FOR, NOT CONFIRMED BY THE MACHINE</source>
        <translation>ASKED FOR, NOT CONFIRMED BY THE MACHINE</translation>
    </message>
    <message>
        <source>IN FORCE, HELD BY YOU</source>
        <translation>IN FORCE, HELD BY YOU</translation>
    </message>
    <message>
        <source>IN FORCE</source>
        <translation>IN FORCE</translation>
    </message>
    <message>
        <source>WHAT TO DO</source>
        <translation>WHAT TO DO</translation>
    </message>
    <message>
        <source>No advice</source>
        <translation>No advice</translation>
    </message>
    <message>
        <source>There is no live picture to advise on</source>
        <translation>There is no live picture to advise on</translation>
    </message>
    <message>
        <source>Nothing to do</source>
        <translation>Nothing to do</translation>
    </message>
    <message>
        <source>Authority is off: Stillcut only watches</source>
        <translation>Authority is off: Stillcut only watches</translation>
    </message>
    <message>
        <source>There is no verdict to act on</source>
        <translation>There is no verdict to act on</translation>
    </message>
    <message>
        <source>The strategy has not decided yet</source>
        <translation>The strategy has not decided yet</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>about %1</translation>
    </message>
    <message>
        <source>The machine does not answer; last values %1 old</source>
        <translation>The machine does not answer; last values %1 old</translation>
    </message>
    <message>
        <source>Values are %1 old</source>
        <translation>Values are %1 old</translation>
    </message>
    <message>
        <source>Another program has the overrides</source>
        <translation>Another program has the overrides</translation>
    </message>
    <message>
        <source>The program has switched overrides off</source>
        <translation>The program has switched overrides off</translation>
    </message>
    <message>
        <source>Feed hold</source>
        <translation>Feed hold</translation>
    </message>
    <message>
        <source>Energy ratio</source>
        <translation>Energy ratio</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Coherence</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Speed</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Feed</translation>
    </message>
    <message>
        <source>Nothing was read from the machine yet</source>
        <translation>Nothing was read from the machine yet</translation>
    </message>
    <message>
        <source>Knobs %1, %2</source>
        <translation>Knobs %1, %2</translation>
    </message>
    <message>
        <source>Knobs %1, %2; feed per tooth %3</source>
        <translation>Knobs %1, %2; feed per tooth %3</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>not read yet</translation>
    </message>
    <message>
        <source>no answer for %1</source>
        <translation>no answer for %1</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>no samples yet</source>
        <translation>no samples yet</translation>
    </message>
    <message>
        <source>nothing for %1</source>
        <translation>nothing for %1</translation>
    </message>
    <message>
        <source>at its limit</source>
        <translation>at its limit</translation>
    </message>
    <message>
        <source>dead</source>
        <translation>dead</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>not a number</translation>
    </message>
    <message>
        <source>samples missing</source>
        <translation>samples missing</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Recording</translation>
    </message>
    <message>
        <source>off</source>
        <translation>off</translation>
    </message>
    <message>
        <source>%1, %2 lost</source>
        <translation>%1, %2 lost</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>stopped</translation>
    </message>
    <message>
        <source>Chatter %1</source>
        <translation>Chatter %1</translation>
    </message>
    <message>
        <source>%1, acting</source>
        <translation>%1, acting</translation>
    </message>
    <message>
        <source>%1, not quieted</source>
        <translation>%1, not quieted</translation>
    </message>
    <message>
        <source>%1, quiet after %2, %3 marked</source>
        <translation>%1, quiet after %2, %3 marked</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>chatter %1</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Drops</translation>
    </message>
    <message>
        <source>Overruns</source>
        <translation>Overruns</translation>
    </message>
    <message>
        <source>Block age</source>
        <translation>Block age</translation>
    </message>
    <message>
        <source>You are in command</source>
        <translation>You are in command</translation>
    </message>
    <message>
        <source>Stillcut is in command</source>
        <translation>Stillcut is in command</translation>
    </message>
    <message>
        <source>You are in command, Stillcut advises</source>
        <translation>You are in command, Stillcut advises</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>since %1</translation>
    </message>
    <message>
        <source>%1, on this simulated machine</source>
        <translation>%1, on this simulated machine</translation>
    </message>
    <message>
        <source>as last heard, %1 ago</source>
        <translation>as last heard, %1 ago</translation>
    </message>
    <message>
        <source>held by you, %1</source>
        <translation>held by you, %1</translation>
    </message>
    <message>
        <source>NO CUT</source>
        <translation>NO CUT</translation>
    </message>
    <message>
        <source>STABLE</source>
        <translation>STABLE</translation>
    </message>
    <message>
        <source>ONSET</source>
        <translation>ONSET</translation>
    </message>
    <message>
        <source>CHATTER</source>
        <translation>CHATTER</translation>
    </message>
    <message>
        <source>period doubling</source>
        <translation>period doubling</translation>
    </message>
    <message>
        <source>forced vibration</source>
        <translation>forced vibration</translation>
    </message>
    <message>
        <source>growing</source>
        <translation>growing</translation>
    </message>
    <message>
        <source>steady</source>
        <translation>steady</translation>
    </message>
    <message>
        <source>dying down</source>
        <translation>dying down</translation>
    </message>
    <message>
        <source>The tool is in the air</source>
        <translation>The tool is in the air</translation>
    </message>
    <message>
        <source>The spindle is running up</source>
        <translation>The spindle is running up</translation>
    </message>
    <message>
        <source>The tool is entering</source>
        <translation>The tool is entering</translation>
    </message>
    <message>
        <source>The tool is leaving</source>
        <translation>The tool is leaving</translation>
    </message>
    <message>
        <source>No chatter in this run</source>
        <translation>No chatter in this run</translation>
    </message>
    <message>
        <source>In chatter so far: %1, %2</source>
        <translation>In chatter so far: %1, %2</translation>
    </message>
    <message>
        <source>NO VERDICT</source>
        <translation>NO VERDICT</translation>
    </message>
    <message>
        <source>The picture is stale: nothing new for %1</source>
        <translation>The picture is stale: nothing new for %1</translation>
    </message>
    <message>
        <source>Last verdict: %1 %2</source>
        <translation>Last verdict: %1 %2</translation>
    </message>
    <message>
        <source>For %1</source>
        <translation>For %1</translation>
    </message>
    <message>
        <source>For %1, %2 of feed</source>
        <translation>For %1, %2 of feed</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>Waiting for the first samples</translation>
    </message>
    <message>
        <source>The run has ended</source>
        <translation>The run has ended</translation>
    </message>
    <message>
        <source>The detector gives no reason</source>
        <translation>The detector gives no reason</translation>
    </message>
    <message>
        <source>Early warning: vibration begins to grow</source>
        <translation>Early warning: vibration begins to grow</translation>
    </message>
    <message>
        <source>The cut is quiet</source>
        <translation>The cut is quiet</translation>
    </message>
    <message>
        <source>The tool does not cut</source>
        <translation>The tool does not cut</translation>
    </message>
    <message>
        <source>Auto: Stillcut commanded the overrides</source>
        <translation>Auto: Stillcut commanded the overrides</translation>
    </message>
    <message>
        <source>Advise: Stillcut proposed</source>
        <translation>Advise: Stillcut proposed</translation>
    </message>
    <message>
        <source>Off: Stillcut watched</source>
        <translation>Off: Stillcut watched</translation>
    </message>
    <message>
        <source>no signal: check cable and supply</source>
        <translation>no signal: check cable and supply</translation>
    </message>
    <message>
        <source>clipped: lower the gain</source>
        <translation>clipped: lower the gain</translation>
    </message>
    <message>
        <source>large constant part: check coupling</source>
        <translation>large constant part: check coupling</translation>
    </message>
    <message>
        <source>far weaker than the others: loose?</source>
        <translation>far weaker than the others: loose?</translation>
    </message>
    <message>
        <source>in order</source>
        <translation>in order</translation>
    </message>
    <message>
        <source>quiet</source>
        <translation>quiet</translation>
    </message>
    <message>
        <source>cut ended</source>
        <translation>cut ended</translation>
    </message>
    <message>
        <source>not quiet</source>
        <translation>not quiet</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>not answered</translation>
    </message>
    <message>
        <source> (simulated)</source>
        <translation> (simulated)</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Tool</translation>
    </message>
    <message>
        <source>, diameter </source>
        <translation>, diameter </translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Teeth</translation>
    </message>
    <message>
        <source>Programmed</source>
        <translation>Programmed</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>Authority</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Length</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensors</translation>
    </message>
    <message>
        <source>%1 at %2 Hz</source>
        <translation>%1 at %2 Hz</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Missing</translation>
    </message>
    <message>
        <source>%1 in %2 gaps</source>
        <translation>%1 in %2 gaps</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>not closed: ends where it was cut off</source>
        <translation>not closed: ends where it was cut off</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Recorded by</translation>
    </message>
    <message>
        <source>This recording holds measurements only: nobody decided while it was made. Vibration and spectrogram are shown as they are.</source>
        <translation>This recording holds measurements only: nobody decided while it was made. Vibration and spectrogram are shown as they are.</translation>
    </message>
    <message>
        <source>No chatter was found.</source>
        <translation>No chatter was found.</translation>
    </message>
    <message>
        <source>Chatter began once</source>
        <translation>Chatter began once</translation>
    </message>
    <message>
        <source>Chatter began %1 times</source>
        <translation>Chatter began %1 times</translation>
    </message>
    <message>
        <source>, first at %1</source>
        <translation>, first at %1</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>; it lasted %1 in all</source>
        <translation>; it lasted %1 in all</translation>
    </message>
    <message>
        <source> and marked %1 of path</source>
        <translation> and marked %1 of path</translation>
    </message>
    <message>
        <source>The overrides were not touched.</source>
        <translation>The overrides were not touched.</translation>
    </message>
    <message>
        <source>Stillcut moved speed and feed once; </source>
        <translation>Stillcut moved speed and feed once; </translation>
    </message>
    <message>
        <source>Stillcut moved speed and feed %1 times; </source>
        <translation>Stillcut moved speed and feed %1 times; </translation>
    </message>
    <message>
        <source>the cut was quiet again.</source>
        <translation>the cut was quiet again.</translation>
    </message>
    <message>
        <source>each time the cut was quiet again.</source>
        <translation>each time the cut was quiet again.</translation>
    </message>
    <message>
        <source>it did not become quiet before the cut ended.</source>
        <translation>it did not become quiet before the cut ended.</translation>
    </message>
    <message>
        <source>once the cut was quiet again before it ended.</source>
        <translation>once the cut was quiet again before it ended.</translation>
    </message>
    <message>
        <source>%1 times the cut was quiet again before it ended.</source>
        <translation>%1 times the cut was quiet again before it ended.</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>No.</translation>
    </message>
    <message>
        <source>At</source>
        <translation>At</translation>
    </message>
    <message>
        <source>Chatter</source>
        <translation>Chatter</translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation>Speed [rpm]</translation>
    </message>
    <message>
        <source>Vibration rms</source>
        <translation>Vibration rms</translation>
    </message>
    <message>
        <source>Quiet after</source>
        <translation>Quiet after</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Marked</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Outcome</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Quantity</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scale</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Peak</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mean</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unit</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Check</translation>
    </message>
    <message>
        <source> (assumed)</source>
        <translation> (assumed)</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Level</translation>
    </message>
    <message>
        <source>What</source>
        <translation>What</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>fault</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>warning</translation>
    </message>
    <message>
        <source>info</source>
        <translation>info</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stable</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>onset</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>chatter</translation>
    </message>
    <message>
        <source>Stillcut moved speed or feed</source>
        <translation>Stillcut moved speed or feed</translation>
    </message>
    <message>
        <source>uncalibrated</source>
        <translation>uncalibrated</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>too short for a spectrogram</source>
        <translation>too short for a spectrogram</translation>
    </message>
    <message>
        <source>Not computed here</source>
        <translation>Not computed here</translation>
    </message>
    <message>
        <source>The diagram does not reach this speed</source>
        <translation>The diagram does not reach this speed</translation>
    </message>
    <message>
        <source>Compute the diagram first</source>
        <translation>Compute the diagram first</translation>
    </message>
    <message>
        <source>STABLE, %1 deeper would be too deep</source>
        <translation>STABLE, %1 deeper would be too deep</translation>
    </message>
    <message>
        <source>CHATTER, %1 too deep</source>
        <translation>CHATTER, %1 too deep</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>limit %1</translation>
    </message>
    <message>
        <source>removes %1</source>
        <translation>removes %1</translation>
    </message>
    <message>
        <source>%1 more time</source>
        <translation>%1 more time</translation>
    </message>
    <message>
        <source>%1 less time</source>
        <translation>%1 less time</translation>
    </message>
    <message>
        <source>, order %1</source>
        <translation>, order %1</translation>
    </message>
    <message>
        <source>fell silent</source>
        <translation>fell silent</translation>
    </message>
    <message>
        <source>loose</source>
        <translation>loose</translation>
    </message>
    <message>
        <source>left its zero</source>
        <translation>left its zero</translation>
    </message>
    <message>
        <source>mains hum</source>
        <translation>mains hum</translation>
    </message>
    <message>
        <source>only noise</source>
        <translation>only noise</translation>
    </message>
    <message>
        <source>one axis twice</source>
        <translation>one axis twice</translation>
    </message>
    <message>
        <source>wrong rate</source>
        <translation>wrong rate</translation>
    </message>
    <message>
        <source>not tried yet</source>
        <translation>not tried yet</translation>
    </message>
    <message>
        <source>%1 in force, alarms: %2, in alarm %3, energy ratio to %4</source>
        <translation>%1 in force, alarms: %2, in alarm %3, energy ratio to %4</translation>
    </message>
    <message>
        <source>no cut</source>
        <translation>no cut</translation>
    </message>
    <message>
        <source>energy ratio</source>
        <translation>energy ratio</translation>
    </message>
    <message>
        <source>frequency [Hz]</source>
        <translation>frequency [Hz]</translation>
    </message>
    <message>
        <source>changes from turn to turn</source>
        <translation>changes from turn to turn</translation>
    </message>
    <message>
        <source>learned noise floor</source>
        <translation>learned noise floor</translation>
    </message>
    <message>
        <source>evidence of growth</source>
        <translation>evidence of growth</translation>
    </message>
    <message>
        <source>purity of the line</source>
        <translation>purity of the line</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>coherence</translation>
    </message>
    <message>
        <source>vibration energy</source>
        <translation>vibration energy</translation>
    </message>
    <message>
        <source>warned ahead by [s]</source>
        <translation>warned ahead by [s]</translation>
    </message>
    <message>
        <source>noise variance</source>
        <translation>noise variance</translation>
    </message>
    <message>
        <source>perturbation power</source>
        <translation>perturbation power</translation>
    </message>
    <message>
        <source>largest root</source>
        <translation>largest root</translation>
    </message>
    <message>
        <source>part outside the harmonics</source>
        <translation>part outside the harmonics</translation>
    </message>
    <message>
        <source>highest line</source>
        <translation>highest line</translation>
    </message>
    <message>
        <source>before every detector</source>
        <translation>before every detector</translation>
    </message>
    <message>
        <source>detector</source>
        <translation>detector</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>strategy</translation>
    </message>
    <message>
        <source>limits of the machine</source>
        <translation>limits of the machine</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>recording</translation>
    </message>
    <message>
        <source>in charge</source>
        <translation>in charge</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>runs</translation>
    </message>
    <message>
        <source>does not run</source>
        <translation>does not run</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatic</translation>
    </message>
    <message>
        <source>on</source>
        <translation>on</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 to %2</translation>
    </message>
    <message>
        <source>true alarm</source>
        <translation>true alarm</translation>
    </message>
    <message>
        <source>false alarm</source>
        <translation>false alarm</translation>
    </message>
    <message>
        <source>heard</source>
        <translation>heard</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>%1: found %2 of %3, false %4 (%5 per hour), delay %6</source>
        <translation>%1: found %2 of %3, false %4 (%5 per hour), delay %6</translation>
    </message>
    <message>
        <source>Every detector runs on it: %1</source>
        <translation>Every detector runs on it: %1</translation>
    </message>
    <message>
        <source>Every detector has run on it</source>
        <translation>Every detector has run on it</translation>
    </message>
    <message>
        <source>Scoring: %1</source>
        <translation>Scoring: %1</translation>
    </message>
    <message>
        <source>Scored against what is marked</source>
        <translation>Scored against what is marked</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Writing %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Written: %1</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>settings</translation>
    </message>
    <message>
        <source>device</source>
        <translation>device</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>samples</translation>
    </message>
    <message>
        <source>link</source>
        <translation>link</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>machine</translation>
    </message>
    <message>
        <source>aliased</source>
        <translation>aliased</translation>
    </message>
    <message>
        <source>%1 old, acts in %2</source>
        <translation>%1 old, acts in %2</translation>
    </message>
    <message>
        <source>No model of this path: identify it, with the tool out of the cut</source>
        <translation>No model of this path: identify it, with the tool out of the cut</translation>
    </message>
    <message>
        <source>Model: leaves %1 unexplained, %2 of 90° phase error left, worst at %3</source>
        <translation>Model: leaves %1 unexplained, %2 of 90° phase error left, worst at %3</translation>
    </message>
    <message>
        <source>Loop delay %1, may grow by %2; identified %3 ago</source>
        <translation>Loop delay %1, may grow by %2; identified %3 ago</translation>
    </message>
    <message>
        <source>It promises no stable control: identify anew</source>
        <translation>It promises no stable control: identify anew</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>starting</translation>
    </message>
    <message>
        <source>let go: %1</source>
        <translation>let go: %1</translation>
    </message>
    <message>
        <source>released</source>
        <translation>released</translation>
    </message>
    <message>
        <source>nobody renewed the lease</source>
        <translation>nobody renewed the lease</translation>
    </message>
    <message>
        <source>a value was not finite</source>
        <translation>a value was not finite</translation>
    </message>
    <message>
        <source>the loop diverged</source>
        <translation>the loop diverged</translation>
    </message>
    <message>
        <source>the actuator was at its end and the vibration grew</source>
        <translation>the actuator was at its end and the vibration grew</translation>
    </message>
    <message>
        <source>control made the vibration worse</source>
        <translation>control made the vibration worse</translation>
    </message>
    <message>
        <source>the error sensor stands still</source>
        <translation>the error sensor stands still</translation>
    </message>
    <message>
        <source>the device lost a block</source>
        <translation>the device lost a block</translation>
    </message>
    <message>
        <source>stroke %1, at its end for %2 of the time</source>
        <translation>stroke %1, at its end for %2 of the time</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>stroke %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: does not run</source>
        <translation>%1: does not run</translation>
    </message>
    <message>
        <source>Identifying the paths: %1</source>
        <translation>Identifying the paths: %1</translation>
    </message>
    <message>
        <source>%1: %2, blocks of %3, worst block %4</source>
        <translation>%1: %2, blocks of %3, worst block %4</translation>
    </message>
    <message>
        <source>%1, %2 blocks late</source>
        <translation>%1, %2 blocks late</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>STABLE, on an island above the limit: less depth would chatter</source>
        <translation>STABLE, on an island above the limit: less depth would chatter</translation>
    </message>
    <message>
        <source>%1 told, not measured yet</source>
        <translation>%1 told, not measured yet</translation>
    </message>
    <message>
        <source>%1 told, %2 measured</source>
        <translation>%1 told, %2 measured</translation>
    </message>
    <message>
        <source>%1, %2 samples lost</source>
        <translation>%1, %2 samples lost</translation>
    </message>
    <message>
        <source>No samples come</source>
        <translation>No samples come</translation>
    </message>
    <message>
        <source>%1: %2, peak %3</source>
        <translation>%1: %2, peak %3</translation>
    </message>
    <message>
        <source>All sensors in order</source>
        <translation>All sensors in order</translation>
    </message>
    <message>
        <source>Sensor in order: %1</source>
        <translation>Sensor in order: %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>not at all</translation>
    </message>
    <message>
        <source>once</source>
        <translation>once</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 times</translation>
    </message>
    <message>
        <source>%1, none marked false</source>
        <translation>%1, none marked false</translation>
    </message>
    <message>
        <source>%1, %2 of them marked false</source>
        <translation>%1, %2 of them marked false</translation>
    </message>
    <message>
        <source>%1 alarmed %2</source>
        <translation>%1 alarmed %2</translation>
    </message>
    <message>
        <source>%1 would have alarmed %2; as recorded: %3</source>
        <translation>%1 would have alarmed %2; as recorded: %3</translation>
    </message>
    <message>
        <source>a loop of its own</source>
        <translation>a loop of its own</translation>
    </message>
    <message>
        <source>Joined device, %1 channels: %2 by this computer's clock, times steady within %3 µs, beside any constant delay of its wire</source>
        <translation>Joined device, %1 channels: %2 by this computer's clock, times steady within %3 µs, beside any constant delay of its wire</translation>
    </message>
    <message>
        <source>No program runs, or the machine is off</source>
        <translation>No program runs, or the machine is off</translation>
    </message>
    <message>
        <source>Reading %1: %2</source>
        <translation>Reading %1: %2</translation>
    </message>
    <message>
        <source>time +%1</source>
        <translation>time +%1</translation>
    </message>
    <message>
        <source>at the next event</source>
        <translation>at the next event</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operator</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Marked as</source>
        <translation>Marked as</translation>
    </message>
    <message>
        <source>By</source>
        <translation>By</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Set to</source>
        <translation>Set to</translation>
    </message>
    <message>
        <source>one this program does not know</source>
        <translation>one this program does not know</translation>
    </message>
    <message>
        <source>The machine is off</source>
        <translation>The machine is off</translation>
    </message>
    <message>
        <source>The machine is off at speed %1, feed %2; Stillcut brings them back when it is on</source>
        <translation>The machine is off at speed %1, feed %2; Stillcut brings them back when it is on</translation>
    </message>
    <message>
        <source>The machine is in alarm</source>
        <translation>The machine is in alarm</translation>
    </message>
    <message>
        <source>No program runs</source>
        <translation>No program runs</translation>
    </message>
    <message>
        <source>The program has locked both overrides (M49)</source>
        <translation>The program has locked both overrides (M49)</translation>
    </message>
    <message>
        <source>The spindle override has no effect: locked by the program (M51, M49), or the machine is at its limit</source>
        <translation>The spindle override has no effect: locked by the program (M51, M49), or the machine is at its limit</translation>
    </message>
    <message>
        <source>The feed override has no effect: locked by the program (M50, M49), or the machine is at its limit</source>
        <translation>The feed override has no effect: locked by the program (M50, M49), or the machine is at its limit</translation>
    </message>
    <message>
        <source>Adaptive feed has no effect: the program has not said M52 P1</source>
        <translation>Adaptive feed has no effect: the program has not said M52 P1</translation>
    </message>
    <message>
        <source>LinuxCNC refuses control: is the control password right?</source>
        <translation>LinuxCNC refuses control: is the control password right?</translation>
    </message>
    <message>
        <source>stillcut-hal does not answer</source>
        <translation>stillcut-hal does not answer</translation>
    </message>
    <message>
        <source>stillcut-hal has not seen the machine's watchdog act</source>
        <translation>stillcut-hal has not seen the machine's watchdog act</translation>
    </message>
    <message>
        <source>The machine's watchdog or the operator's switch has taken Stillcut out</source>
        <translation>The machine's watchdog or the operator's switch has taken Stillcut out</translation>
    </message>
    <message>
        <source>identifying, %1</source>
        <translation>identifying, %1</translation>
    </message>
    <message>
        <source>%1 let go</source>
        <translation>%1 let go</translation>
    </message>
    <message>
        <source>The active table let go along %1: %2</source>
        <translation>The active table let go along %1: %2</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>The marker is in the file</source>
        <translation>The marker is in the file</translation>
    </message>
    <message>
        <source>Vibration %1</source>
        <translation>Vibration %1</translation>
    </message>
    <message>
        <source>Vibration %1: the chatter is gone</source>
        <translation>Vibration %1: the chatter is gone</translation>
    </message>
    <message>
        <source>Vibration %1: no chatter, %2 is the teeth</source>
        <translation>Vibration %1: no chatter, %2 is the teeth</translation>
    </message>
    <message>
        <source>Onset %1, quiet after %2, nothing marked</source>
        <translation>Onset %1, quiet after %2, nothing marked</translation>
    </message>
    <message>
        <source>Onsets in this run: %1, no chatter</source>
        <translation>Onsets in this run: %1, no chatter</translation>
    </message>
    <message>
        <source>ADVICE IN THE REPLAY</source>
        <translation>ADVICE IN THE REPLAY</translation>
    </message>
    <message>
        <source>live, %1</source>
        <translation>live, %1</translation>
    </message>
    <message>
        <source>being checked</source>
        <translation>being checked</translation>
    </message>
    <message>
        <source>regenerative</source>
        <translation>regenerative</translation>
    </message>
    <message>
        <source>Not computed so deep</source>
        <translation>Not computed so deep</translation>
    </message>
    <message>
        <source>no limit found down to %1</source>
        <translation>no limit found down to %1</translation>
    </message>
    <message>
        <source>STABLE, no limit found down to %1</source>
        <translation>STABLE, no limit found down to %1</translation>
    </message>
    <message>
        <source>limit deeper than %1</source>
        <translation>limit deeper than %1</translation>
    </message>
    <message>
        <source>, B: %1</source>
        <translation>, B: %1</translation>
    </message>
    <message>
        <source>dB re 1 %1</source>
        <translation>dB re 1 %1</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>%1 rms</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>The replay is paused</translation>
    </message>
    <message>
        <source>Feed [%1]</source>
        <translation>Feed [%1]</translation>
    </message>
    <message>
        <source>Another run begins on the page Set up: GUIDE or PROFILE</source>
        <translation>Another run begins on the page Set up: GUIDE or PROFILE</translation>
    </message>
    <message>
        <source>%1, PAUSED</source>
        <translation>%1, PAUSED</translation>
    </message>
    <message>
        <source>%1, ENDED</source>
        <translation>%1, ENDED</translation>
    </message>
    <message>
        <source>The onset of chatter was found once</source>
        <translation>The onset of chatter was found once</translation>
    </message>
    <message>
        <source>The onset of chatter was found %1 times</source>
        <translation>The onset of chatter was found %1 times</translation>
    </message>
    <message>
        <source>; it became no chatter</source>
        <translation>; it became no chatter</translation>
    </message>
    <message>
        <source>Onset %1</source>
        <translation>Onset %1</translation>
    </message>
    <message>
        <source>%1, going on</source>
        <translation>%1, going on</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ActiveView</name>
    <message>
        <source>IDENTIFY</source>
        <translation>IDENTIFY</translation>
    </message>
    <message>
        <source>Identify the paths, with the tool out of the cut</source>
        <translation>Identify the paths, with the tool out of the cut</translation>
    </message>
    <message>
        <source>START</source>
        <translation>START</translation>
    </message>
    <message>
        <source>Start active control</source>
        <translation>Start active control</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop active control</source>
        <translation>Stop active control</translation>
    </message>
    <message>
        <source>Axis x</source>
        <translation>Axis x</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>Axis y</translation>
    </message>
    <message>
        <source>There is no active work-holder here.</source>
        <translation>There is no active work-holder here.</translation>
    </message>
    <message>
        <source>%1: nothing yet</source>
        <translation>%1: nothing yet</translation>
    </message>
    <message>
        <source>Nothing is known of its lines yet</source>
        <translation>Nothing is known of its lines yet</translation>
    </message>
    <message>
        <source>By the model, against the cut left alone: %1</source>
        <translation>By the model, against the cut left alone: %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::AdvicePanel</name>
    <message>
        <source>ACCEPT</source>
        <translation>ACCEPT</translation>
    </message>
    <message>
        <source>NOT NOW</source>
        <translation>NOT NOW</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>What to do</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::AnalyseTools</name>
    <message>
        <source>LIVE</source>
        <translation>LIVE</translation>
    </message>
    <message>
        <source>WATERFALL</source>
        <translation>WATERFALL</translation>
    </message>
    <message>
        <source>LINEAR</source>
        <translation>LINEAR</translation>
    </message>
    <message>
        <source>ORDERS</source>
        <translation>ORDERS</translation>
    </message>
    <message>
        <source>MAX HOLD</source>
        <translation>MAX HOLD</translation>
    </message>
    <message>
        <source>REFERENCE</source>
        <translation>REFERENCE</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Channel</translation>
    </message>
    <message>
        <source>Channel of spectrogram, spectrum and signal</source>
        <translation>Channel of spectrogram, spectrum and signal</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ChannelModel</name>
    <message>
        <source>Channel</source>
        <translation>Channel</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Quantity</translation>
    </message>
    <message>
        <source>Per device unit</source>
        <translation>Per device unit</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axis</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::CommandBar</name>
    <message>
        <source>OFF</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>ADVISE</source>
        <translation>ADVISE</translation>
    </message>
    <message>
        <source>AUTO</source>
        <translation>AUTO</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>BACK TO 100 %</source>
        <translation>BACK TO 100 %</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>Authority</translation>
    </message>
    <message>
        <source>This profile does not grant Auto</source>
        <translation>This profile does not grant Auto</translation>
    </message>
    <message>
        <source>END HOLD</source>
        <translation>END HOLD</translation>
    </message>
    <message>
        <source>Esc, now %1</source>
        <translation>Esc, now %1</translation>
    </message>
    <message>
        <source>AUTO?</source>
        <translation>AUTO?</translation>
    </message>
    <message>
        <source>touch again to confirm</source>
        <translation>touch again to confirm</translation>
    </message>
    <message>
        <source>This machine has no watchdog</source>
        <translation>This machine has no watchdog</translation>
    </message>
    <message>
        <source>if Stillcut dies, its overrides stay</source>
        <translation>if Stillcut dies, its overrides stay</translation>
    </message>
    <message>
        <source>F4, no watchdog</source>
        <translation>F4, no watchdog</translation>
    </message>
    <message>
        <source>ACCEPT</source>
        <translation>ACCEPT</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::DisplayPanel</name>
    <message>
        <source>Display</source>
        <translation>Display</translation>
    </message>
    <message>
        <source>LIGHT</source>
        <translation>LIGHT</translation>
    </message>
    <message>
        <source>DARK</source>
        <translation>DARK</translation>
    </message>
    <message>
        <source>HIGH CONTRAST</source>
        <translation>HIGH CONTRAST</translation>
    </message>
    <message>
        <source>METRIC</source>
        <translation>METRIC</translation>
    </message>
    <message>
        <source>INCH</source>
        <translation>INCH</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::HeaderBar</name>
    <message>
        <source>SIMULATED MACHINE</source>
        <translation>SIMULATED MACHINE</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Display</translation>
    </message>
    <message>
        <source>Theme, units, language (F11); next theme (F12)</source>
        <translation>Theme, units, language (F11); next theme (F12)</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::HistoryMap</name>
    <message>
        <source>SPECTROGRAM</source>
        <translation>SPECTROGRAM</translation>
    </message>
    <message>
        <source>Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Click: cursor A, with Shift B.</source>
        <translation>Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Click: cursor A, with Shift B.</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>Waiting for the first samples</translation>
    </message>
    <message>
        <source>order</source>
        <translation>order</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::InterventionList</name>
    <message>
        <source>WAS CHATTER</source>
        <translation>WAS CHATTER</translation>
    </message>
    <message>
        <source>FALSE ALARM</source>
        <translation>FALSE ALARM</translation>
    </message>
    <message>
        <source>Last interventions</source>
        <translation>Last interventions</translation>
    </message>
    <message>
        <source>LAST INTERVENTIONS</source>
        <translation>LAST INTERVENTIONS</translation>
    </message>
    <message>
        <source>None in this run</source>
        <translation>None in this run</translation>
    </message>
    <message>
        <source>I HEAR IT</source>
        <translation>I HEAR IT</translation>
    </message>
    <message>
        <source>Marks chatter that was not told</source>
        <translation>Marks chatter that was not told</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LevelSpectrum</name>
    <message>
        <source>Spectrum of the first channel, now</source>
        <translation>Spectrum of the first channel, now</translation>
    </message>
    <message>
        <source>No samples come</source>
        <translation>No samples come</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LobeChart</name>
    <message>
        <source>Stability diagram</source>
        <translation>Stability diagram</translation>
    </message>
    <message>
        <source>spindle speed [rpm]</source>
        <translation>spindle speed [rpm]</translation>
    </message>
    <message>
        <source>depth of cut [in]</source>
        <translation>depth of cut [in]</translation>
    </message>
    <message>
        <source>depth of cut [mm]</source>
        <translation>depth of cut [mm]</translation>
    </message>
    <message>
        <source>Drag the ring, or use the arrow keys: what if the cut ran at this speed and depth? Two fingers, the wheel or plus and minus zoom, zero shows the whole.</source>
        <translation>Drag the ring, or use the arrow keys: what if the cut ran at this speed and depth? Two fingers, the wheel or plus and minus zoom, zero shows the whole.</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LobesPage</name>
    <message>
        <source>ZEROTH ORDER</source>
        <translation>ZEROTH ORDER</translation>
    </message>
    <message>
        <source>SEMI-DISCRETE</source>
        <translation>SEMI-DISCRETE</translation>
    </message>
    <message>
        <source>EXACT</source>
        <translation>EXACT</translation>
    </message>
    <message>
        <source>COMPUTE</source>
        <translation>COMPUTE</translation>
    </message>
    <message>
        <source>Progress of the diagram</source>
        <translation>Progress of the diagram</translation>
    </message>
    <message>
        <source>What if the speed were</source>
        <translation>What if the speed were</translation>
    </message>
    <message>
        <source>and the depth</source>
        <translation>and the depth</translation>
    </message>
    <message>
        <source>Speed, what if</source>
        <translation>Speed, what if</translation>
    </message>
    <message>
        <source>Depth, what if</source>
        <translation>Depth, what if</translation>
    </message>
    <message>
        <source>Quiet pockets at this depth</source>
        <translation>Quiet pockets at this depth</translation>
    </message>
    <message>
        <source>CANCEL</source>
        <translation>CANCEL</translation>
    </message>
    <message>
        <source>Computing; the diagram before stays until it is done</source>
        <translation>Computing; the diagram before stays until it is done</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelled</translation>
    </message>
    <message>
        <source>Cannot be computed: %1</source>
        <translation>Cannot be computed: %1</translation>
    </message>
    <message>
        <source>In brackets: beyond the override's reach</source>
        <translation>In brackets: beyond the override's reach</translation>
    </message>
    <message>
        <source>Choose a pocket to try its best speed</source>
        <translation>Choose a pocket to try its best speed</translation>
    </message>
    <message>
        <source>Nothing new arrives: the working point is not shown</source>
        <translation>Nothing new arrives: the working point is not shown</translation>
    </message>
    <message>
        <source>The recording does not say which modes its tool has: there is no diagram of this cut. The machine's own comes back with its cut.</source>
        <translation>The recording does not say which modes its tool has: there is no diagram of this cut. The machine's own comes back with its cut.</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>The replay is paused</translation>
    </message>
    <message>
        <source>The depth of cut is not known: tell it under Set up, MACHINE, and the working point is shown</source>
        <translation>The depth of cut is not known: tell it under Set up, MACHINE, and the working point is shown</translation>
    </message>
    <message>
        <source>, depth of cut up to %1</source>
        <translation>, depth of cut up to %1</translation>
    </message>
    <message>
        <source>The modes of this tool are not known. A tap test gives the file of its modes (F1 tells how): name it under Set up, TOOLS; the diagram needs nothing else.</source>
        <translation>The modes of this tool are not known. A tap test gives the file of its modes (F1 tells how): name it under Set up, TOOLS; the diagram needs nothing else.</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ManualPanel</name>
    <message>
        <source>CONTENTS</source>
        <translation>CONTENTS</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>BACK</translation>
    </message>
    <message>
        <source>CLOSE</source>
        <translation>CLOSE</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MarkSheet</name>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Label of the span</source>
        <translation>Label of the span</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Note of the next marker</source>
        <translation>Note of the next marker</translation>
    </message>
    <message>
        <source>SPAN</source>
        <translation>SPAN</translation>
    </message>
    <message>
        <source>Mark the selected span with the label</source>
        <translation>Mark the selected span with the label</translation>
    </message>
    <message>
        <source>CHANGE</source>
        <translation>CHANGE</translation>
    </message>
    <message>
        <source>Give the chosen marker this label and note</source>
        <translation>Give the chosen marker this label and note</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>REMOVE</translation>
    </message>
    <message>
        <source>Remove the chosen marker</source>
        <translation>Remove the chosen marker</translation>
    </message>
    <message>
        <source>CHATTER</source>
        <translation>CHATTER</translation>
    </message>
    <message>
        <source>Mark a true alarm</source>
        <translation>Mark a true alarm</translation>
    </message>
    <message>
        <source>FALSE</source>
        <translation>FALSE</translation>
    </message>
    <message>
        <source>Mark a false alarm</source>
        <translation>Mark a false alarm</translation>
    </message>
    <message>
        <source>I HEAR IT</source>
        <translation>I HEAR IT</translation>
    </message>
    <message>
        <source>I hear it now</source>
        <translation>I hear it now</translation>
    </message>
    <message>
        <source>NOTE</source>
        <translation>NOTE</translation>
    </message>
    <message>
        <source>Mark with the note</source>
        <translation>Mark with the note</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markers</translation>
    </message>
    <message>
        <source>Marked: %1</source>
        <translation>Marked: %1</translation>
    </message>
    <message>
        <source>Marker changed</source>
        <translation>Marker changed</translation>
    </message>
    <message>
        <source>Marker removed</source>
        <translation>Marker removed</translation>
    </message>
    <message>
        <source>Marker put back</source>
        <translation>Marker put back</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>UNDO</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MarkerModel</name>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MembershipPlot</name>
    <message>
        <source>Fuzzy sets</source>
        <translation>Fuzzy sets</translation>
    </message>
    <message>
        <source>How far an error belongs to each set</source>
        <translation>How far an error belongs to each set</translation>
    </message>
    <message>
        <source>Peaks at %1, %2, %3 of the range</source>
        <translation>Peaks at %1, %2, %3 of the range</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::OperatePage</name>
    <message>
        <source>channel %1</source>
        <translation>channel %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::OverrideTable</name>
    <message>
        <source>Speed and feed</source>
        <translation>Speed and feed</translation>
    </message>
    <message>
        <source>%1: programmed %2, override %3, actual %4 %5</source>
        <translation>%1: programmed %2, override %3, actual %4 %5</translation>
    </message>
    <message>
        <source>programmed</source>
        <translation>programmed</translation>
    </message>
    <message>
        <source>override</source>
        <translation>override</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>actual</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ParamModel</name>
    <message>
        <source>Locked while the cut runs: the limits of the machine hold for a whole run</source>
        <translation>Locked while the cut runs: the limits of the machine hold for a whole run</translation>
    </message>
    <message>
        <source>Locked while the cut runs: a file keeps one way of recording</source>
        <translation>Locked while the cut runs: a file keeps one way of recording</translation>
    </message>
    <message>
        <source>Locked while the cut runs: filters and windows are sized for it before the first block</source>
        <translation>Locked while the cut runs: filters and windows are sized for it before the first block</translation>
    </message>
    <message>
        <source>follows what is learned from the cut</source>
        <translation>follows what is learned from the cut</translation>
    </message>
    <message>
        <source>chose %1</source>
        <translation>chose %1</translation>
    </message>
    <message>
        <source>off</source>
        <translation>off</translation>
    </message>
    <message>
        <source>on</source>
        <translation>on</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Value</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unit</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Default</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1: %2 (%3)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>chose %1 (%2)</source>
        <translation>chose %1 (%2)</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ParamRow</name>
    <message>
        <source>Less: %1</source>
        <translation>Less: %1</translation>
    </message>
    <message>
        <source>More: %1</source>
        <translation>More: %1</translation>
    </message>
    <message>
        <source>AUTO</source>
        <translation>AUTO</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatic: %1</translation>
    </message>
    <message>
        <source>Not taken. Allowed: %1</source>
        <translation>Not taken. Allowed: %1</translation>
    </message>
    <message>
        <source>%1   (A and B differ)</source>
        <translation>%1   (A and B differ)</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Default: %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PartModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PathFitPlot</name>
    <message>
        <source>Fit of the path's model</source>
        <translation>Fit of the path's model</translation>
    </message>
    <message>
        <source>No model: identify the path</source>
        <translation>No model: identify the path</translation>
    </message>
    <message>
        <source>Phase error; hatched: control goes wrong</source>
        <translation>Phase error; hatched: control goes wrong</translation>
    </message>
    <message>
        <source>Coherence; below the mark it says little</source>
        <translation>Coherence; below the mark it says little</translation>
    </message>
    <message>
        <source>Magnitude: measured grey, model blue and dashed</source>
        <translation>Magnitude: measured grey, model blue and dashed</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PocketTable</name>
    <message>
        <source>Beyond what the speed override reaches</source>
        <translation>Beyond what the speed override reaches</translation>
    </message>
    <message>
        <source>(%1)</source>
        <translation>(%1)</translation>
    </message>
    <message>
        <source>quiet, rpm</source>
        <translation>quiet, rpm</translation>
    </message>
    <message>
        <source>best, rpm</source>
        <translation>best, rpm</translation>
    </message>
    <message>
        <source>down to</source>
        <translation>down to</translation>
    </message>
    <message>
        <source>&gt; %1</source>
        <translation>&gt; %1</translation>
    </message>
    <message>
        <source>No limit found: the search ended there</source>
        <translation>No limit found: the search ended there</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PresetBar</name>
    <message>
        <source>SAVE</source>
        <translation>SAVE</translation>
    </message>
    <message>
        <source>DELETE</source>
        <translation>DELETE</translation>
    </message>
    <message>
        <source>GO TO</source>
        <translation>GO TO</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Choose a preset, or type a name and save what is on show</source>
        <translation>Choose a preset, or type a name and save what is on show</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>14:03:20 or -12 s</source>
        <translation>14:03:20 or -12 s</translation>
    </message>
    <message>
        <source>No cursor: click into a plot, with Shift for B</source>
        <translation>No cursor: click into a plot, with Shift for B</translation>
    </message>
    <message>
        <source>Not a moment: write 14:03:20, or -12 for seconds ago</source>
        <translation>Not a moment: write 14:03:20, or -12 for seconds ago</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>UNDO</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PresetList</name>
    <message>
        <source>Last 10 s</source>
        <translation>Last 10 s</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Orders</translation>
    </message>
    <message>
        <source>Entry, 1 s</source>
        <translation>Entry, 1 s</translation>
    </message>
    <message>
        <source>2 min, max hold</source>
        <translation>2 min, max hold</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::RuleEditor</name>
    <message>
        <source>SPEED</source>
        <translation>SPEED</translation>
    </message>
    <message>
        <source>Rules of the speed</source>
        <translation>Rules of the speed</translation>
    </message>
    <message>
        <source>FEED</source>
        <translation>FEED</translation>
    </message>
    <message>
        <source>Rules of the feed</source>
        <translation>Rules of the feed</translation>
    </message>
    <message>
        <source>Lower this rule</source>
        <translation>Lower this rule</translation>
    </message>
    <message>
        <source>Raise this rule</source>
        <translation>Raise this rule</translation>
    </message>
    <message>
        <source>Nothing has been learned</source>
        <translation>Nothing has been learned</translation>
    </message>
    <message>
        <source>Lessons: %1. No rule of this table has moved</source>
        <translation>Lessons: %1. No rule of this table has moved</translation>
    </message>
    <message>
        <source>Lessons: %1. Rules of this table that moved: %2, the furthest by %3</source>
        <translation>Lessons: %1. Rules of this table that moved: %2, the furthest by %3</translation>
    </message>
    <message>
        <source>These values cannot be used together: rules must fall as coherence rises, and the energy limit must be above its reference. Those before them still act</source>
        <translation>These values cannot be used together: rules must fall as coherence rises, and the energy limit must be above its reference. Those before them still act</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::RuleGrid</name>
    <message>
        <source>Rule table</source>
        <translation>Rule table</translation>
    </message>
    <message>
        <source>error %1, change %2: %3 (%4)</source>
        <translation>error %1, change %2: %3 (%4)</translation>
    </message>
    <message>
        <source>%1, learned %2</source>
        <translation>%1, learned %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionList</name>
    <message>
        <source>Find job or tool</source>
        <translation>Find job or tool</translation>
    </message>
    <message>
        <source>JOB</source>
        <translation>JOB</translation>
    </message>
    <message>
        <source>Order by job</source>
        <translation>Order by job</translation>
    </message>
    <message>
        <source>TOOL</source>
        <translation>TOOL</translation>
    </message>
    <message>
        <source>Order by tool</source>
        <translation>Order by tool</translation>
    </message>
    <message>
        <source>TIME</source>
        <translation>TIME</translation>
    </message>
    <message>
        <source>Order by time</source>
        <translation>Order by time</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Recordings</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Folder of the recordings</translation>
    </message>
    <message>
        <source>There are no recordings to work on here.</source>
        <translation>There are no recordings to work on here.</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>RECORDED</translation>
    </message>
    <message>
        <source>Recordings of the folder</source>
        <translation>Recordings of the folder</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULATED</translation>
    </message>
    <message>
        <source>Simulated cuts, replayed as recordings are</source>
        <translation>Simulated cuts, replayed as recordings are</translation>
    </message>
    <message>
        <source>No recordings here. Cuts are recorded as the page SET UP, RECORDING says.</source>
        <translation>No recordings here. Cuts are recorded as the page SET UP, RECORDING says.</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionListModel</name>
    <message>
        <source>%1, tool %2, of %3</source>
        <translation>%1, tool %2, of %3</translation>
    </message>
    <message>
        <source>%1, markers: %2</source>
        <translation>%1, markers: %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionTimeline</name>
    <message>
        <source>Recording over time</source>
        <translation>Recording over time</translation>
    </message>
    <message>
        <source>Choose a recording on the left</source>
        <translation>Choose a recording on the left</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>vibration</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>as recorded</translation>
    </message>
    <message>
        <source>before</source>
        <translation>before</translation>
    </message>
    <message>
        <source>after</source>
        <translation>after</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionsPage</name>
    <message>
        <source>ON ALL PAGES</source>
        <translation>ON ALL PAGES</translation>
    </message>
    <message>
        <source>Show the replay on all pages</source>
        <translation>Show the replay on all pages</translation>
    </message>
    <message>
        <source>MARK</source>
        <translation>MARK</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markers</translation>
    </message>
    <message>
        <source>COMPARE</source>
        <translation>COMPARE</translation>
    </message>
    <message>
        <source>Compare, score and export</source>
        <translation>Compare, score and export</translation>
    </message>
    <message>
        <source>ALL DETECTORS</source>
        <translation>ALL DETECTORS</translation>
    </message>
    <message>
        <source>Run every detector on this recording</source>
        <translation>Run every detector on this recording</translation>
    </message>
    <message>
        <source>SCORE</source>
        <translation>SCORE</translation>
    </message>
    <message>
        <source>Score this recording against its markers</source>
        <translation>Score this recording against its markers</translation>
    </message>
    <message>
        <source>SCORE ALL</source>
        <translation>SCORE ALL</translation>
    </message>
    <message>
        <source>Score the whole folder</source>
        <translation>Score the whole folder</translation>
    </message>
    <message>
        <source>EXPORT</source>
        <translation>EXPORT</translation>
    </message>
    <message>
        <source>Export the selected span, or the whole</source>
        <translation>Export the selected span, or the whole</translation>
    </message>
    <message>
        <source>REPORT</source>
        <translation>REPORT</translation>
    </message>
    <message>
        <source>Write a report</source>
        <translation>Write a report</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop what is being worked on</source>
        <translation>Stop what is being worked on</translation>
    </message>
    <message>
        <source>FROM TUNE</source>
        <translation>FROM TUNE</translation>
    </message>
    <message>
        <source>Take what was changed on the Tune page</source>
        <translation>Take what was changed on the Tune page</translation>
    </message>
    <message>
        <source>What if: settings, KEY=VALUE, with spaces between them</source>
        <translation>What if: settings, KEY=VALUE, with spaces between them</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>What if</translation>
    </message>
    <message>
        <source>Every page shows the replay; the touches below still go to the machine</source>
        <translation>Every page shows the replay; the touches below still go to the machine</translation>
    </message>
    <message>
        <source>Every page shows the cut again</source>
        <translation>Every page shows the cut again</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Written: %1</translation>
    </message>
    <message>
        <source>No recording is open</source>
        <translation>No recording is open</translation>
    </message>
    <message>
        <source>%1 · %2 · alarms: %3 · in chatter %4</source>
        <translation>%1 · %2 · alarms: %3 · in chatter %4</translation>
    </message>
    <message>
        <source>no verdict</source>
        <translation>no verdict</translation>
    </message>
    <message>
        <source>Drag over the picture or choose a marked span first: the loop repeats it</source>
        <translation>Drag over the picture or choose a marked span first: the loop repeats it</translation>
    </message>
    <message>
        <source>AS %1</source>
        <translation>AS %1</translation>
    </message>
    <message>
        <source>The next format of EXPORT</source>
        <translation>The next format of EXPORT</translation>
    </message>
    <message>
        <source>Not scored: %1</source>
        <translation>Not scored: %1</translation>
    </message>
    <message>
        <source>BESIDE</source>
        <translation>BESIDE</translation>
    </message>
    <message>
        <source>Keep this recording beside the next one that is opened</source>
        <translation>Keep this recording beside the next one that is opened</translation>
    </message>
    <message>
        <source>Open another recording: this one stays beside it, as the dashed line</source>
        <translation>Open another recording: this one stays beside it, as the dashed line</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SettingsForm</name>
    <message>
        <source>yes</source>
        <translation>yes</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>not set</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 to %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupDraft</name>
    <message>
        <source>no machine link is chosen: the program will only watch</source>
        <translation>no machine link is chosen: the program will only watch</translation>
    </message>
    <message>
        <source>no device is chosen</source>
        <translation>no device is chosen</translation>
    </message>
    <message>
        <source>the number of teeth is not known</source>
        <translation>the number of teeth is not known</translation>
    </message>
    <message>
        <source>the programmed speed is not known</source>
        <translation>the programmed speed is not known</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupFinder</name>
    <message>
        <source>Hosts to look at besides this computer</source>
        <translation>Hosts to look at besides this computer</translation>
    </message>
    <message>
        <source>FIND</source>
        <translation>FIND</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Look for serial ports and machines, once</source>
        <translation>Look for serial ports and machines, once</translation>
    </message>
    <message>
        <source>USE</source>
        <translation>USE</translation>
    </message>
    <message>
        <source>Take the chosen one as the link</source>
        <translation>Take the chosen one as the link</translation>
    </message>
    <message>
        <source>TEST THE LINK</source>
        <translation>TEST THE LINK</translation>
    </message>
    <message>
        <source>Test the link step by step; nothing moves</source>
        <translation>Test the link step by step; nothing moves</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>SAVE</translation>
    </message>
    <message>
        <source>Save the link with its delay into the profile</source>
        <translation>Save the link with its delay into the profile</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Saved: %1</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>Looking</translation>
    </message>
    <message>
        <source>Nothing answers. A path or a host can be typed on the left.</source>
        <translation>Nothing answers. A path or a host can be typed on the left.</translation>
    </message>
    <message>
        <source>Nothing is looked for before you ask.</source>
        <translation>Nothing is looked for before you ask.</translation>
    </message>
    <message>
        <source>FIND THE MACHINE</source>
        <translation>FIND THE MACHINE</translation>
    </message>
    <message>
        <source>more hosts, or 192.168.1.0/24</source>
        <translation>more hosts, or 192.168.1.0/24</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>What was found</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupGuide</name>
    <message>
        <source>Two ways to begin</source>
        <translation>Two ways to begin</translation>
    </message>
    <message>
        <source>Look at a simulated cut first: it chatters as it gets deeper, and the program finds the quiet speed. Nothing has to be connected.</source>
        <translation>Look at a simulated cut first: it chatters as it gets deeper, and the program finds the quiet speed. Nothing has to be connected.</translation>
    </message>
    <message>
        <source>SHOW ME A SIMULATED CUT</source>
        <translation>SHOW ME A SIMULATED CUT</translation>
    </message>
    <message>
        <source>Or connect this machine, step by step. Each step says what is still missing; nothing is commanded while authority is Off.</source>
        <translation>Or connect this machine, step by step. Each step says what is still missing; nothing is commanded while authority is Off.</translation>
    </message>
    <message>
        <source>1  MACHINE</source>
        <translation>1  MACHINE</translation>
    </message>
    <message>
        <source>2  SENSORS</source>
        <translation>2  SENSORS</translation>
    </message>
    <message>
        <source>3  TOOL</source>
        <translation>3  TOOL</translation>
    </message>
    <message>
        <source>4  TRY OUT, SAVE, START</source>
        <translation>4  TRY OUT, SAVE, START</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>ready</translation>
    </message>
    <message>
        <source>still open</source>
        <translation>still open</translation>
    </message>
    <message>
        <source>in force</source>
        <translation>in force</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupMachine</name>
    <message>
        <source>Name of the machine</source>
        <translation>Name of the machine</translation>
    </message>
    <message>
        <source>Programmed speed in rpm</source>
        <translation>Programmed speed in rpm</translation>
    </message>
    <message>
        <source>AUTO MAY BE CHOSEN</source>
        <translation>AUTO MAY BE CHOSEN</translation>
    </message>
    <message>
        <source>Auto may be chosen on this machine</source>
        <translation>Auto may be chosen on this machine</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation>Speed, rpm</translation>
    </message>
    <message>
        <source>LINK TO THE CONTROL</source>
        <translation>LINK TO THE CONTROL</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>Programmed feed</translation>
    </message>
    <message>
        <source>Feed, %1</source>
        <translation>Feed, %1</translation>
    </message>
    <message>
        <source>Programmed feed in %1</source>
        <translation>Programmed feed in %1</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>Depth of cut</translation>
    </message>
    <message>
        <source>The depth was not taken: it must be a number from %1 to %2, or nothing where it is not known</source>
        <translation>The depth was not taken: it must be a number from %1 to %2, or nothing where it is not known</translation>
    </message>
    <message>
        <source>Depth, %1</source>
        <translation>Depth, %1</translation>
    </message>
    <message>
        <source>Depth of cut in %1</source>
        <translation>Depth of cut in %1</translation>
    </message>
    <message>
        <source>Deepest cut of the programme, %1 to %2; the Lobes page shows the cut at this depth</source>
        <translation>Deepest cut of the programme, %1 to %2; the Lobes page shows the cut at this depth</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unknown</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupPage</name>
    <message>
        <source>There is nothing to set up here.</source>
        <translation>There is nothing to set up here.</translation>
    </message>
    <message>
        <source>GUIDE</source>
        <translation>GUIDE</translation>
    </message>
    <message>
        <source>MACHINE</source>
        <translation>MACHINE</translation>
    </message>
    <message>
        <source>SENSORS</source>
        <translation>SENSORS</translation>
    </message>
    <message>
        <source>TOOLS</source>
        <translation>TOOLS</translation>
    </message>
    <message>
        <source>PROFILE</source>
        <translation>PROFILE</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>RECORDING</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupProfile</name>
    <message>
        <source>Name of the profile</source>
        <translation>Name of the profile</translation>
    </message>
    <message>
        <source>TRY OUT</source>
        <translation>TRY OUT</translation>
    </message>
    <message>
        <source>Try out step by step; nothing is commanded</source>
        <translation>Try out step by step; nothing is commanded</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>SAVE</translation>
    </message>
    <message>
        <source>Save the profile</source>
        <translation>Save the profile</translation>
    </message>
    <message>
        <source>START</source>
        <translation>START</translation>
    </message>
    <message>
        <source>LOAD</source>
        <translation>LOAD</translation>
    </message>
    <message>
        <source>Load the chosen profile</source>
        <translation>Load the chosen profile</translation>
    </message>
    <message>
        <source>PROFILES</source>
        <translation>PROFILES</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profiles</translation>
    </message>
    <message>
        <source>DETECTOR IN CHARGE</source>
        <translation>DETECTOR IN CHARGE</translation>
    </message>
    <message>
        <source>STRATEGY</source>
        <translation>STRATEGY</translation>
    </message>
    <message>
        <source>Save the profile and begin with it</source>
        <translation>Save the profile and begin with it</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Saved: %1</translation>
    </message>
    <message>
        <source>It runs. Authority is Off.</source>
        <translation>It runs. Authority is Off.</translation>
    </message>
    <message>
        <source>Loaded: %1</source>
        <translation>Loaded: %1</translation>
    </message>
    <message>
        <source>A demonstration runs, no profile.</source>
        <translation>A demonstration runs, no profile.</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>In force: %1</translation>
    </message>
    <message>
        <source>Try it out first: each step says what was found. Nothing is commanded.</source>
        <translation>Try it out first: each step says what was found. Nothing is commanded.</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupRecording</name>
    <message>
        <source>Who is at the machine</source>
        <translation>Who is at the machine</translation>
    </message>
    <message>
        <source>Job: what is being made</source>
        <translation>Job: what is being made</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Folder of the recordings</translation>
    </message>
    <message>
        <source>RECORD EVERY CUT</source>
        <translation>RECORD EVERY CUT</translation>
    </message>
    <message>
        <source>Record every cut of this machine</source>
        <translation>Record every cut of this machine</translation>
    </message>
    <message>
        <source>WHAT RUNS NOW</source>
        <translation>WHAT RUNS NOW</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operator</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>WHAT IS KEPT</source>
        <translation>WHAT IS KEPT</translation>
    </message>
    <message>
        <source>nothing is recorded</source>
        <translation>nothing is recorded</translation>
    </message>
    <message>
        <source>Every sample, from the beginning of the cut to its end.</source>
        <translation>Every sample, from the beginning of the cut to its end.</translation>
    </message>
    <message>
        <source>What surrounds alarms, faults and touches; the time before is held in memory until then.</source>
        <translation>What surrounds alarms, faults and touches; the time before is held in memory until then.</translation>
    </message>
    <message>
        <source>Verdicts and indicators without samples, as a history.</source>
        <translation>Verdicts and indicators without samples, as a history.</translation>
    </message>
    <message>
        <source>job</source>
        <translation>job</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>tool</translation>
    </message>
    <message>
        <source>Files are named by job, tool and time: %1</source>
        <translation>Files are named by job, tool and time: %1</translation>
    </message>
    <message>
        <source>Nothing is recorded. What is chosen here begins with START on the page PROFILE.</source>
        <translation>Nothing is recorded. What is chosen here begins with START on the page PROFILE.</translation>
    </message>
    <message>
        <source>Recording begins with the next event, and with what was before it.</source>
        <translation>Recording begins with the next event, and with what was before it.</translation>
    </message>
    <message>
        <source>Writes %1</source>
        <translation>Writes %1</translation>
    </message>
    <message>
        <source>Recording has stopped; what was recorded is in %1</source>
        <translation>Recording has stopped; what was recorded is in %1</translation>
    </message>
    <message>
        <source>Deleted because of the limits: %1, the last one %2</source>
        <translation>Deleted because of the limits: %1, the last one %2</translation>
    </message>
    <message>
        <source>Too old or too large, but could not be deleted: %1. Free the room by hand: %2</source>
        <translation>Too old or too large, but could not be deleted: %1. Free the room by hand: %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupSensorTrial</name>
    <message>
        <source>Level of the calibrator, as 94 dB, 1 g or 10</source>
        <translation>Level of the calibrator, as 94 dB, 1 g or 10</translation>
    </message>
    <message>
        <source>Frequency of the calibrator in Hz</source>
        <translation>Frequency of the calibrator in Hz</translation>
    </message>
    <message>
        <source>CALIBRATE</source>
        <translation>CALIBRATE</translation>
    </message>
    <message>
        <source>Hear the calibrator on the chosen channel</source>
        <translation>Hear the calibrator on the chosen channel</translation>
    </message>
    <message>
        <source>KNOCK</source>
        <translation>KNOCK</translation>
    </message>
    <message>
        <source>Hear knocks along the axis of the chosen channel</source>
        <translation>Hear knocks along the axis of the chosen channel</translation>
    </message>
    <message>
        <source>Calibrator</source>
        <translation>Calibrator</translation>
    </message>
    <message>
        <source>Is it this sensor that lies along its axis?</source>
        <translation>Is it this sensor that lies along its axis?</translation>
    </message>
    <message>
        <source>The frequency is no number above 0.</source>
        <translation>The frequency is no number above 0.</translation>
    </message>
    <message>
        <source>Listening to the calibrator</source>
        <translation>Listening to the calibrator</translation>
    </message>
    <message>
        <source>Knock along the axis now, a few times</source>
        <translation>Knock along the axis now, a few times</translation>
    </message>
    <message>
        <source>Knock along %1 now, a few times, near the sensor</source>
        <translation>Knock along %1 now, a few times, near the sensor</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupSensors</name>
    <message>
        <source>DEVICE</source>
        <translation>DEVICE</translation>
    </message>
    <message>
        <source>CHANNELS</source>
        <translation>CHANNELS</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Channels</translation>
    </message>
    <message>
        <source>ADD CHANNEL</source>
        <translation>ADD CHANNEL</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Add a channel</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>REMOVE</translation>
    </message>
    <message>
        <source>Remove the chosen channel</source>
        <translation>Remove the chosen channel</translation>
    </message>
    <message>
        <source>WHAT RUNS NOW</source>
        <translation>WHAT RUNS NOW</translation>
    </message>
    <message>
        <source>LISTEN</source>
        <translation>LISTEN</translation>
    </message>
    <message>
        <source>Listen to the chosen device</source>
        <translation>Listen to the chosen device</translation>
    </message>
    <message>
        <source>THE CHOSEN DEVICE</source>
        <translation>THE CHOSEN DEVICE</translation>
    </message>
    <message>
        <source>Opening the device</source>
        <translation>Opening the device</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupTools</name>
    <message>
        <source>Tool</source>
        <translation>Tool</translation>
    </message>
    <message>
        <source>Holder and stick-out</source>
        <translation>Holder and stick-out</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Teeth</translation>
    </message>
    <message>
        <source>Pitch angles, degrees</source>
        <translation>Pitch angles, degrees</translation>
    </message>
    <message>
        <source>File of its modes</source>
        <translation>File of its modes</translation>
    </message>
    <message>
        <source>Highest speed, rpm</source>
        <translation>Highest speed, rpm</translation>
    </message>
    <message>
        <source>KEEP</source>
        <translation>KEEP</translation>
    </message>
    <message>
        <source>Keep this tool</source>
        <translation>Keep this tool</translation>
    </message>
    <message>
        <source>USE IT</source>
        <translation>USE IT</translation>
    </message>
    <message>
        <source>Use this tool for the profile</source>
        <translation>Use this tool for the profile</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>REMOVE</translation>
    </message>
    <message>
        <source>Remove this tool</source>
        <translation>Remove this tool</translation>
    </message>
    <message>
        <source>CHATTERED HERE</source>
        <translation>CHATTERED HERE</translation>
    </message>
    <message>
        <source>Note that it chatters now</source>
        <translation>Note that it chatters now</translation>
    </message>
    <message>
        <source>NEW TOOL</source>
        <translation>NEW TOOL</translation>
    </message>
    <message>
        <source>New tool</source>
        <translation>New tool</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Tools</translation>
    </message>
    <message>
        <source>even</source>
        <translation>even</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>not measured</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>no limit</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Kept</translation>
    </message>
    <message>
        <source>The profile uses it now</source>
        <translation>The profile uses it now</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Removed</translation>
    </message>
    <message>
        <source>Chattered at %1 rpm, %2 Hz  %3</source>
        <translation>Chattered at %1 rpm, %2 Hz  %3</translation>
    </message>
    <message>
        <source>No tools yet: begin with NEW TOOL</source>
        <translation>No tools yet: begin with NEW TOOL</translation>
    </message>
    <message>
        <source>Noted</source>
        <translation>Noted</translation>
    </message>
    <message>
        <source>Not kept: the pitch needs one angle per tooth, 360 degrees together</source>
        <translation>Not kept: the pitch needs one angle per tooth, 360 degrees together</translation>
    </message>
    <message>
        <source>PUT IT BACK</source>
        <translation>PUT IT BACK</translation>
    </message>
    <message>
        <source>Put the removed tool back</source>
        <translation>Put the removed tool back</translation>
    </message>
    <message>
        <source>It is back</source>
        <translation>It is back</translation>
    </message>
    <message>
        <source>Not kept yet</source>
        <translation>Not kept yet</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diameter</translation>
    </message>
    <message>
        <source>Diameter, %1</source>
        <translation>Diameter, %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SpectrogramWidget</name>
    <message>
        <source>Spectrogram of the last ten seconds</source>
        <translation>Spectrogram of the last ten seconds</translation>
    </message>
    <message>
        <source>X: axis in Hz, orders or rpm. Page Up, Page Down: reach of the axis.</source>
        <translation>X: axis in Hz, orders or rpm. Page Up, Page Down: reach of the axis.</translation>
    </message>
    <message>
        <source>no chatter</source>
        <translation>no chatter</translation>
    </message>
    <message>
        <source>chatter at %1</source>
        <translation>chatter at %1</translation>
    </message>
    <message>
        <source>SPECTROGRAM</source>
        <translation>SPECTROGRAM</translation>
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
        <translation>%1, last 10 s</translation>
    </message>
    <message>
        <source>STALE: nothing new arrives</source>
        <translation>STALE: nothing new arrives</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>Waiting for the first samples</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>order</source>
        <translation>order</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>now</source>
        <translation>now</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>1× tooth</source>
        <translation>1× tooth</translation>
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
        <translation>Spectrum</translation>
    </message>
    <message>
        <source>Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom.</source>
        <translation>Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom.</translation>
    </message>
    <message>
        <source>SPECTRUM</source>
        <translation>SPECTRUM</translation>
    </message>
    <message>
        <source>SPECTRUM AT A, %1</source>
        <translation>SPECTRUM AT A, %1</translation>
    </message>
    <message>
        <source>SPECTRUM, NEWEST</source>
        <translation>SPECTRUM, NEWEST</translation>
    </message>
    <message>
        <source>cursor: %1</source>
        <translation>cursor: %1</translation>
    </message>
    <message>
        <source>order</source>
        <translation>order</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>chatter %1</translation>
    </message>
    <message>
        <source>SPECTRUM, STALE: nothing new arrives</source>
        <translation>SPECTRUM, STALE: nothing new arrives</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::StatusStrip</name>
    <message>
        <source>State of the chain</source>
        <translation>State of the chain</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TimePlot</name>
    <message>
        <source>STALE: nothing new arrives</source>
        <translation>STALE: nothing new arrives</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ToolModel</name>
    <message>
        <source>chattered here before: %1</source>
        <translation>chattered here before: %1</translation>
    </message>
    <message>
        <source>D %1, %2 teeth</source>
        <translation>D %1, %2 teeth</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TracePlot</name>
    <message>
        <source>SIGNAL</source>
        <translation>SIGNAL</translation>
    </message>
    <message>
        <source>No samples kept of this stretch</source>
        <translation>No samples kept of this stretch</translation>
    </message>
    <message>
        <source>peak %1</source>
        <translation>peak %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TrackPlot</name>
    <message>
        <source>DETECTORS</source>
        <translation>DETECTORS</translation>
    </message>
    <message>
        <source>Low: stable. Half: onset. Full: chatter. Hatched: no verdict. The line is the first indicator.</source>
        <translation>Low: stable. Half: onset. Full: chatter. Hatched: no verdict. The line is the first indicator.</translation>
    </message>
    <message>
        <source>low: stable, half: onset, full: chatter; line: first indicator</source>
        <translation>low: stable, half: onset, full: chatter; line: first indicator</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TransportBar</name>
    <message>
        <source>To the beginning</source>
        <translation>To the beginning</translation>
    </message>
    <message>
        <source>A block back</source>
        <translation>A block back</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>PLAY</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Play or pause</translation>
    </message>
    <message>
        <source>A block on</source>
        <translation>A block on</translation>
    </message>
    <message>
        <source>LOOP</source>
        <translation>LOOP</translation>
    </message>
    <message>
        <source>Repeat the selected span</source>
        <translation>Repeat the selected span</translation>
    </message>
    <message>
        <source>Pace of the replay</source>
        <translation>Pace of the replay</translation>
    </message>
    <message>
        <source>PAUSE</source>
        <translation>PAUSE</translation>
    </message>
    <message>
        <source>%1 x</source>
        <translation>%1 x</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>fastest</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 of %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TuneDesk</name>
    <message>
        <source>to the defaults</source>
        <translation>to the defaults</translation>
    </message>
    <message>
        <source>as the run began</source>
        <translation>as the run began</translation>
    </message>
    <message>
        <source>both sides alike</source>
        <translation>both sides alike</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TunePage</name>
    <message>
        <source>Methods</source>
        <translation>Methods</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>UNDO</translation>
    </message>
    <message>
        <source>REDO</source>
        <translation>REDO</translation>
    </message>
    <message>
        <source>AS BEGUN</source>
        <translation>AS BEGUN</translation>
    </message>
    <message>
        <source>DEFAULTS</source>
        <translation>DEFAULTS</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>SAVE</translation>
    </message>
    <message>
        <source>WHAT IT SEES NOW</source>
        <translation>WHAT IT SEES NOW</translation>
    </message>
    <message>
        <source>COMPARE</source>
        <translation>COMPARE</translation>
    </message>
    <message>
        <source>A = B</source>
        <translation>A = B</translation>
    </message>
    <message>
        <source>Use the values of side A</source>
        <translation>Use the values of side A</translation>
    </message>
    <message>
        <source>Use the values of side B</source>
        <translation>Use the values of side B</translation>
    </message>
    <message>
        <source>Make the other side like this one</source>
        <translation>Make the other side like this one</translation>
    </message>
    <message>
        <source>Nothing to tune: this session has no methods of its own</source>
        <translation>Nothing to tune: this session has no methods of its own</translation>
    </message>
    <message>
        <source>B = A</source>
        <translation>B = A</translation>
    </message>
    <message>
        <source>Both sides are alike. Take B, change something, and go to and fro.</source>
        <translation>Both sides are alike. Take B, change something, and go to and fro.</translation>
    </message>
    <message>
        <source>Values that differ: %1</source>
        <translation>Values that differ: %1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Nothing yet</translation>
    </message>
    <message>
        <source>It does not run</source>
        <translation>It does not run</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Kept in %1</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>Not kept: %1</translation>
    </message>
    <message>
        <source>The picture is stale: nothing new for %1</source>
        <translation>The picture is stale: nothing new for %1</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>The replay is paused</translation>
    </message>
    <message>
        <source>Learned by itself</source>
        <translation>Learned by itself</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::VerdictSign</name>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
</context>
</TS>