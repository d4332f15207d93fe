<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Core</name>
    <message>
        <source>High-pass edge</source>
        <translation>Hochpass-Grenze</translation>
    </message>
    <message>
        <source>Removes offset and drift below this frequency; auto: a quarter of the spindle frequency</source>
        <translation>Entfernt Gleichanteil und Drift unter dieser Frequenz; automatisch: ein Viertel der Spindelfrequenz</translation>
    </message>
    <message>
        <source>Doubt of the told speed</source>
        <translation>Unsicherheit der genannten Drehzahl</translation>
    </message>
    <message>
        <source>How far the told spindle speed may be from the true one, as a ratio; searched at entry</source>
        <translation>Wie weit die genannte Drehzahl von der wahren abweichen darf, als Verhältnis; beim Eintritt gesucht</translation>
    </message>
    <message>
        <source>Cut above air</source>
        <translation>Schnitt über Luft</translation>
    </message>
    <message>
        <source>A cut is this much louder than the quietest the sensor has heard</source>
        <translation>Ein Schnitt ist um so viel lauter als das Leiseste, was der Sensor gehört hat</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmonische</translation>
    </message>
    <message>
        <source>Spindle harmonics of the periodic part (L, eq. 9); auto: 32 as the rate allows</source>
        <translation>Spindelharmonische des periodischen Teils (L, Gl. 9); automatisch: 32, soweit die Rate erlaubt</translation>
    </message>
    <message>
        <source>NLMS step</source>
        <translation>NLMS-Schrittweite</translation>
    </message>
    <message>
        <source>mu of eq. 19; auto: a memory of two turns (paper: 0.5)</source>
        <translation>mu aus Gl. 19; automatisch: Gedächtnis von zwei Umdrehungen (Arbeit: 0.5)</translation>
    </message>
    <message>
        <source>NLMS leak</source>
        <translation>NLMS-Verlust</translation>
    </message>
    <message>
        <source>lambda of eq. 19; auto: leaves 1 % of a harmonic (paper: 0.9995)</source>
        <translation>lambda aus Gl. 19; automatisch: lässt 1 % einer Harmonischen übrig (Arbeit: 0.9995)</translation>
    </message>
    <message>
        <source>AR drift</source>
        <translation>AR-Drift</translation>
    </message>
    <message>
        <source>R_v of eq. 21, for a signal of unit variance</source>
        <translation>R_v aus Gl. 21, für ein Signal der Varianz eins</translation>
    </message>
    <message>
        <source>AR noise</source>
        <translation>AR-Rauschen</translation>
    </message>
    <message>
        <source>R_w of eq. 21, for a signal of unit variance</source>
        <translation>R_w aus Gl. 21, für ein Signal der Varianz eins</translation>
    </message>
    <message>
        <source>Reflected distance</source>
        <translation>Gespiegelter Abstand</translation>
    </message>
    <message>
        <source>Distance from the unit circle at which an unstable root is put back inside</source>
        <translation>Abstand vom Einheitskreis, in dem eine instabile Wurzel wieder nach innen gesetzt wird</translation>
    </message>
    <message>
        <source>Working rate</source>
        <translation>Arbeitsrate</translation>
    </message>
    <message>
        <source>Least rate the method works at; auto: 10 kHz, as the paper</source>
        <translation>Kleinste Rate, mit der das Verfahren arbeitet; automatisch: 10 kHz wie in der Arbeit</translation>
    </message>
    <message>
        <source>Variance limit</source>
        <translation>Varianzgrenze</translation>
    </message>
    <message>
        <source>Variance of the residual (squared unit of the sensor) that is an alarm; auto: growth above the learned floor</source>
        <translation>Varianz des Rests (Sensoreinheit im Quadrat), die ein Alarm ist; automatisch: Wachstum über den gelernten Grundwert</translation>
    </message>
    <message>
        <source>Root of an alarm</source>
        <translation>Wurzel eines Alarms</translation>
    </message>
    <message>
        <source>Magnitude of the dominant root below which the residual is noise and not chatter</source>
        <translation>Betrag der dominanten Wurzel, unter dem der Rest Rauschen und kein Rattern ist</translation>
    </message>
    <message>
        <source>Evidence for onset</source>
        <translation>Nachweis des Beginns</translation>
    </message>
    <message>
        <source>Log-likelihood ratio of growth against the learned floor that makes an onset (onset_test.h)</source>
        <translation>Log-Likelihood-Verhältnis des Wachstums gegen den gelernten Grundwert, das einen Beginn ausmacht (onset_test.h)</translation>
    </message>
    <message>
        <source>Chatter ratio</source>
        <translation>Ratteranteil</translation>
    </message>
    <message>
        <source>Energy ratio from which a cut is in full chatter</source>
        <translation>Energieanteil, ab dem ein Schnitt voll rattert</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Length of the spectrum; auto: 28 turns, at most 1.5 s (paper: 0.512 s)</source>
        <translation>Länge des Spektrums; automatisch: 28 Umdrehungen, höchstens 1.5 s (Arbeit: 0.512 s)</translation>
    </message>
    <message>
        <source>Spectra per window</source>
        <translation>Spektren je Fenster</translation>
    </message>
    <message>
        <source>A new spectrum is taken this often within one window</source>
        <translation>So oft wird in einem Fenster ein neues Spektrum gebildet</translation>
    </message>
    <message>
        <source>Line threshold</source>
        <translation>Linienschwelle</translation>
    </message>
    <message>
        <source>Amplitude (unit of the sensor) of a line that is chatter; auto: growth above the learned floor</source>
        <translation>Amplitude (Sensoreinheit) einer Linie, die Rattern ist; automatisch: Wachstum über den gelernten Grundwert</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Half width of the mask on a harmonic, in bins</source>
        <translation>Halbe Breite der Maske auf einer Harmonischen, in Linien</translation>
    </message>
    <message>
        <source>Purity</source>
        <translation>Reinheit</translation>
    </message>
    <message>
        <source>Part of the power between the harmonics that a chatter line holds at least</source>
        <translation>Mindestanteil einer Ratterlinie an der Leistung zwischen den Harmonischen</translation>
    </message>
    <message>
        <source>Spindle harmonics the Kalman filter removes (N, eq. 16); auto: 12 tooth passings, at least 32, as the sampling rate allows</source>
        <translation>Spindelharmonische, die das Kalman-Filter entfernt (N, Gl. 16); automatisch: 12 Zahneingriffe, mindestens 32, soweit die Abtastrate erlaubt</translation>
    </message>
    <message>
        <source>Process noise ratio</source>
        <translation>Prozessrausch-Verhältnis</translation>
    </message>
    <message>
        <source>Q/R of the Kalman filter (eq. 20); auto: a memory of two turns</source>
        <translation>Q/R des Kalman-Filters (Gl. 20); automatisch: Gedächtnis von zwei Umdrehungen</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>Kovarianz</translation>
    </message>
    <message>
        <source>Covariance of the Kalman filter: its settled gain from the start, or eq. 20 at every sample, which is right from the first turn on and costs some twenty times as much</source>
        <translation>Kovarianz des Kalman-Filters: von Anfang an die eingeschwungene Verstärkung, oder Gl. 20 bei jedem Abtastwert, was ab der ersten Umdrehung stimmt und etwa das Zwanzigfache kostet</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>eingeschwungen</translation>
    </message>
    <message>
        <source>full</source>
        <translation>voll</translation>
    </message>
    <message>
        <source>Smallest onset</source>
        <translation>Kleinster Beginn</translation>
    </message>
    <message>
        <source>Unrepeated vibration over all vibration (amplitudes) below which growth is not yet called onset</source>
        <translation>Nicht wiederkehrende zu aller Schwingung (Amplituden), unter der Wachstum noch kein Beginn heißt</translation>
    </message>
    <message>
        <source>Log-likelihood ratio of growth against the learned noise that makes an onset; a stable cut lasts e to this power turns, on average, without a false alarm</source>
        <translation>Log-Likelihood-Verhältnis des Wachstums gegen das gelernte Rauschen, das einen Beginn ausmacht; ein stabiler Schnitt läuft im Mittel e hoch so viele Umdrehungen ohne Fehlalarm</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>welch: averaged magnitude-squared coherence; paper: eq. 3-5 of one transform</source>
        <translation>welch: gemittelte quadrierte Kohärenz; paper: Gl. 3-5 einer Transformation</translation>
    </message>
    <message>
        <source>welch</source>
        <translation>Welch</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>wie veröffentlicht</translation>
    </message>
    <message>
        <source>Sharpening</source>
        <translation>Schärfung</translation>
    </message>
    <message>
        <source>Weighting of the smoothed coherence; printed: eq. 3-17b as it stands</source>
        <translation>Gewichtung der geglätteten Kohärenz; gedruckt: Gl. 3-17b, wie sie steht</translation>
    </message>
    <message>
        <source>monotone</source>
        <translation>monoton</translation>
    </message>
    <message>
        <source>printed</source>
        <translation>gedruckt</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Length of one transform; auto: 12 turns, at most 1 s</source>
        <translation>Länge einer Transformation; automatisch: 12 Umdrehungen, höchstens 1 s</translation>
    </message>
    <message>
        <source>Averages</source>
        <translation>Mittelungen</translation>
    </message>
    <message>
        <source>Memory of the averages, in segments (each overlaps the last by 7/8)</source>
        <translation>Gedächtnis der Mittelung in Abschnitten (jeder überlappt den vorigen um 7/8)</translation>
    </message>
    <message>
        <source>Window from</source>
        <translation>Fenster ab</translation>
    </message>
    <message>
        <source>Where the window of eq. 3-18 begins to rise (paper: 170 Hz); auto: no window</source>
        <translation>Wo das Fenster aus Gl. 3-18 zu steigen beginnt (Arbeit: 170 Hz); automatisch: kein Fenster</translation>
    </message>
    <message>
        <source>Window to</source>
        <translation>Fenster bis</translation>
    </message>
    <message>
        <source>Where the window of eq. 3-18 has fallen (paper: 250 Hz); auto: no window</source>
        <translation>Wo das Fenster aus Gl. 3-18 abgefallen ist (Arbeit: 250 Hz); automatisch: kein Fenster</translation>
    </message>
    <message>
        <source>Coherence reference</source>
        <translation>Kohärenz-Sollwert</translation>
    </message>
    <message>
        <source>gamma_ref: coherence ratio that is chatter&apos;s</source>
        <translation>gamma_ref: Kohärenz, die Rattern bedeutet</translation>
    </message>
    <message>
        <source>Energy reference</source>
        <translation>Energie-Sollwert</translation>
    </message>
    <message>
        <source>E_ref (unit of the sensor) of eq. 3-21; auto: growth above the learned floor</source>
        <translation>E_ref (Sensoreinheit) aus Gl. 3-21; automatisch: Wachstum über den gelernten Grundwert</translation>
    </message>
    <message>
        <source>Part of the cross spectrum between the harmonics that a chatter line holds at least</source>
        <translation>Mindestanteil einer Ratterlinie am Kreuzspektrum zwischen den Harmonischen</translation>
    </message>
    <message>
        <source>Confirmation</source>
        <translation>Bestätigung</translation>
    </message>
    <message>
        <source>How long an alarm stands at one frequency before the first move</source>
        <translation>Wie lange ein Alarm bei einer Frequenz steht, bevor zuerst eingegriffen wird</translation>
    </message>
    <message>
        <source>Confirmation after a move</source>
        <translation>Bestätigung nach einem Eingriff</translation>
    </message>
    <message>
        <source>How long chatter stands at the new speed before that speed is given up</source>
        <translation>Wie lange Rattern bei der neuen Drehzahl steht, bevor sie aufgegeben wird</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Einschwingen</translation>
    </message>
    <message>
        <source>After the spindle has reached a new speed it is judged no sooner</source>
        <translation>Früher wird nach Erreichen einer neuen Drehzahl nicht geurteilt</translation>
    </message>
    <message>
        <source>Speeds to try</source>
        <translation>Zu versuchende Drehzahlen</translation>
    </message>
    <message>
        <source>After so many speeds without quiet it goes back and advises only</source>
        <translation>Nach so vielen Drehzahlen ohne Ruhe geht es zurück und rät nur noch</translation>
    </message>
    <message>
        <source>Memory of tried speeds</source>
        <translation>Gedächtnis der Versuche</translation>
    </message>
    <message>
        <source>After so long without an alarm the tried speeds are forgotten</source>
        <translation>Nach so langer Zeit ohne Alarm sind die versuchten Drehzahlen vergessen</translation>
    </message>
    <message>
        <source>Pause after giving up</source>
        <translation>Pause nach dem Aufgeben</translation>
    </message>
    <message>
        <source>So long nothing is tried again after no speed was quiet</source>
        <translation>So lange wird nichts mehr versucht, wenn keine Drehzahl ruhig war</translation>
    </message>
    <message>
        <source>Smoothing of the frequency</source>
        <translation>Glättung der Frequenz</translation>
    </message>
    <message>
        <source>Time constant of the low-pass on the chatter frequency</source>
        <translation>Zeitkonstante des Tiefpasses auf der Ratterfrequenz</translation>
    </message>
    <message>
        <source>Act on</source>
        <translation>Eingreifen bei</translation>
    </message>
    <message>
        <source>Move at the onset of chatter, or only when it is full chatter</source>
        <translation>Beim Beginn des Ratterns eingreifen oder erst bei vollem Rattern</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>Rattern</translation>
    </message>
    <message>
        <source>Freeze when quiet</source>
        <translation>Bei Ruhe einfrieren</translation>
    </message>
    <message>
        <source>Stay at the actual speed once chatter clears, for narrow lobes, instead of going on to the last target</source>
        <translation>Bei der tatsächlichen Drehzahl bleiben, sobald das Rattern aufhört (für schmale Bereiche), statt zum letzten Ziel weiterzugehen</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>mu_c of eq. 32</source>
        <translation>mu_c aus Gl. 32</translation>
    </message>
    <message>
        <source>Smoothing of the level</source>
        <translation>Glättung des Pegels</translation>
    </message>
    <message>
        <source>lambda_c of eq. 33</source>
        <translation>lambda_c aus Gl. 33</translation>
    </message>
    <message>
        <source>Unit of a step</source>
        <translation>Einheit eines Schritts</translation>
    </message>
    <message>
        <source>What a step of 1 in eq. 32 is, in percent of the programmed speed</source>
        <translation>Was ein Schritt von 1 in Gl. 32 ist, in Prozent der programmierten Drehzahl</translation>
    </message>
    <message>
        <source>Control period</source>
        <translation>Regelperiode</translation>
    </message>
    <message>
        <source>Time from one step of eq. 32 to the next</source>
        <translation>Zeit von einem Schritt der Gl. 32 zum nächsten</translation>
    </message>
    <message>
        <source>Step of the search</source>
        <translation>Suchschritt</translation>
    </message>
    <message>
        <source>Distance of neighbouring trials, in percent of the programmed speed</source>
        <translation>Abstand benachbarter Versuche, in Prozent der programmierten Drehzahl</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Speeds to choose from: the nearest, only lower, only higher</source>
        <translation>Zur Wahl stehende Drehzahlen: die nächste, nur niedrigere, nur höhere</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>nächste</translation>
    </message>
    <message>
        <source>down</source>
        <translation>niedriger</translation>
    </message>
    <message>
        <source>up</source>
        <translation>höher</translation>
    </message>
    <message>
        <source>Phase factor</source>
        <translation>Phasenfaktor</translation>
    </message>
    <message>
        <source>Fraction of a wave left between two cuts (nu of eq. 3)</source>
        <translation>Bruchteil einer Welle zwischen zwei Schnitten (nu aus Gl. 3)</translation>
    </message>
    <message>
        <source>Control cycle</source>
        <translation>Regelzyklus</translation>
    </message>
    <message>
        <source>Speed and feed are changed once per cycle</source>
        <translation>Drehzahl und Vorschub werden einmal je Zyklus geändert</translation>
    </message>
    <message>
        <source>Time for the whole range</source>
        <translation>Zeit für den ganzen Bereich</translation>
    </message>
    <message>
        <source>At full output the whole range of an override takes this long (the paper&apos;s limit: a second)</source>
        <translation>Bei voller Ausgabe dauert der ganze Bereich eines Overrides so lange (Grenze der Arbeit: eine Sekunde)</translation>
    </message>
    <message>
        <source>Coherence above which speed and feed fall (gamma_ref)</source>
        <translation>Kohärenz, über der Drehzahl und Vorschub fallen (gamma_ref)</translation>
    </message>
    <message>
        <source>Vibration over that of the stable cut above which speed and feed fall</source>
        <translation>Schwingung zu der des stabilen Schnitts, über der Drehzahl und Vorschub fallen</translation>
    </message>
    <message>
        <source>Energy limit</source>
        <translation>Energiegrenze</translation>
    </message>
    <message>
        <source>Vibration over that of the stable cut at which the feed goes to its lowest; at twice that the feed is held</source>
        <translation>Schwingung zu der des stabilen Schnitts, bei der der Vorschub auf sein Kleinstes geht; beim Doppelten wird er angehalten</translation>
    </message>
    <message>
        <source>Highest overrides</source>
        <translation>Höchste Overrides</translation>
    </message>
    <message>
        <source>Speed and feed rise no further than this fraction of the programmed values</source>
        <translation>Drehzahl und Vorschub steigen höchstens auf diesen Anteil der programmierten Werte</translation>
    </message>
    <message>
        <source>Rest of the speed</source>
        <translation>Ruhe der Drehzahl</translation>
    </message>
    <message>
        <source>The speed does not rise for so long after an alarm</source>
        <translation>So lange steigt die Drehzahl nach einem Alarm nicht</translation>
    </message>
    <message>
        <source>Learning weight</source>
        <translation>Lerngewicht</translation>
    </message>
    <message>
        <source>Share of the coherence error that the rules learn (w of eq. 3-32)</source>
        <translation>Anteil des Kohärenzfehlers, den die Regeln lernen (w aus Gl. 3-32)</translation>
    </message>
    <message>
        <source>Direct tuning</source>
        <translation>Direkte Abstimmung</translation>
    </message>
    <message>
        <source>By coherence alone (eq. 3-37) or by coherence and energy (3-36)</source>
        <translation>Nur nach Kohärenz (Gl. 3-37) oder nach Kohärenz und Energie (3-36)</translation>
    </message>
    <message>
        <source>single</source>
        <translation>einfach</translation>
    </message>
    <message>
        <source>double</source>
        <translation>doppelt</translation>
    </message>
    <message>
        <source>Coherence weight</source>
        <translation>Kohärenzgewicht</translation>
    </message>
    <message>
        <source>Weight of the coherence error (w_gamma of eq. 3-34)</source>
        <translation>Gewicht des Kohärenzfehlers (w_gamma aus Gl. 3-34)</translation>
    </message>
    <message>
        <source>Energy weight</source>
        <translation>Energiegewicht</translation>
    </message>
    <message>
        <source>Weight of the energy error (w_E of eq. 3-35)</source>
        <translation>Gewicht des Energiefehlers (w_E aus Gl. 3-35)</translation>
    </message>
    <message>
        <source>Lowest speed override</source>
        <translation>Kleinster Drehzahl-Override</translation>
    </message>
    <message>
        <source>Spindle speed is never driven below this fraction of the programmed speed</source>
        <translation>Die Drehzahl wird nie unter diesen Anteil der programmierten gesenkt</translation>
    </message>
    <message>
        <source>Highest speed override</source>
        <translation>Größter Drehzahl-Override</translation>
    </message>
    <message>
        <source>Spindle speed is never driven above this fraction of the programmed speed</source>
        <translation>Die Drehzahl wird nie über diesen Anteil der programmierten gehoben</translation>
    </message>
    <message>
        <source>Lowest feed override</source>
        <translation>Kleinster Vorschub-Override</translation>
    </message>
    <message>
        <source>Feed is never driven below this fraction of the programmed feed</source>
        <translation>Der Vorschub wird nie unter diesen Anteil des programmierten gesenkt</translation>
    </message>
    <message>
        <source>Highest feed override</source>
        <translation>Größter Vorschub-Override</translation>
    </message>
    <message>
        <source>Feed is never driven above this fraction of the programmed feed</source>
        <translation>Der Vorschub wird nie über diesen Anteil des programmierten gehoben</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>Kleinste Drehzahl</translation>
    </message>
    <message>
        <source>Spindle speed is never driven below this; auto: no such limit</source>
        <translation>Die Drehzahl wird nie darunter gesenkt; automatisch: keine solche Grenze</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Größte Drehzahl</translation>
    </message>
    <message>
        <source>Spindle speed is never driven above this: the machine&apos;s limit; auto: none</source>
        <translation>Die Drehzahl wird nie darüber gehoben: die Grenze der Maschine; automatisch: keine</translation>
    </message>
    <message>
        <source>Highest speed of the tool</source>
        <translation>Größte Drehzahl des Werkzeugs</translation>
    </message>
    <message>
        <source>What the maker allows the tool; auto: no such limit</source>
        <translation>Was der Hersteller dem Werkzeug erlaubt; automatisch: keine solche Grenze</translation>
    </message>
    <message>
        <source>Highest speed of the holder</source>
        <translation>Größte Drehzahl des Halters</translation>
    </message>
    <message>
        <source>What holder and balancing allow; auto: no such limit</source>
        <translation>Was Halter und Wuchtung erlauben; automatisch: keine solche Grenze</translation>
    </message>
    <message>
        <source>Highest cutting speed</source>
        <translation>Größte Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>The edge is never driven faster than this; needs the tool&apos;s diameter; auto: no such limit</source>
        <translation>Die Schneide läuft nie schneller; braucht den Werkzeugdurchmesser; automatisch: keine solche Grenze</translation>
    </message>
    <message>
        <source>Lowest feed</source>
        <translation>Kleinster Vorschub</translation>
    </message>
    <message>
        <source>Feed is never driven below this; auto: no such limit</source>
        <translation>Der Vorschub wird nie darunter gesenkt; automatisch: keine solche Grenze</translation>
    </message>
    <message>
        <source>Highest feed</source>
        <translation>Größter Vorschub</translation>
    </message>
    <message>
        <source>Feed is never driven above this; auto: no such limit</source>
        <translation>Der Vorschub wird nie darüber gehoben; automatisch: keine solche Grenze</translation>
    </message>
    <message>
        <source>Lowest feed per tooth</source>
        <translation>Kleinster Zahnvorschub</translation>
    </message>
    <message>
        <source>Our overrides never lower the feed per tooth below this fraction of the programmed one: the edge would rub</source>
        <translation>Unsere Overrides senken den Zahnvorschub nie unter diesen Anteil des programmierten: die Schneide würde reiben</translation>
    </message>
    <message>
        <source>Highest feed per tooth</source>
        <translation>Größter Zahnvorschub</translation>
    </message>
    <message>
        <source>Our overrides never raise the feed per tooth above this fraction of the programmed one</source>
        <translation>Unsere Overrides heben den Zahnvorschub nie über diesen Anteil des programmierten</translation>
    </message>
    <message>
        <source>Speed change per step</source>
        <translation>Drehzahländerung je Schritt</translation>
    </message>
    <message>
        <source>Largest change of the speed override in one step of the gate, in percent of the programmed speed</source>
        <translation>Größte Änderung des Drehzahl-Overrides in einem Schritt des Tors, in Prozent der programmierten Drehzahl</translation>
    </message>
    <message>
        <source>Speed change per second</source>
        <translation>Drehzahländerung je Sekunde</translation>
    </message>
    <message>
        <source>Fastest change of the speed override, in percent of the programmed speed per second</source>
        <translation>Schnellste Änderung des Drehzahl-Overrides, in Prozent der programmierten Drehzahl je Sekunde</translation>
    </message>
    <message>
        <source>Feed change per step</source>
        <translation>Vorschubänderung je Schritt</translation>
    </message>
    <message>
        <source>Largest change of the feed override in one step of the gate, in percent of the programmed feed</source>
        <translation>Größte Änderung des Vorschub-Overrides in einem Schritt des Tors, in Prozent des programmierten Vorschubs</translation>
    </message>
    <message>
        <source>Feed change per second</source>
        <translation>Vorschubänderung je Sekunde</translation>
    </message>
    <message>
        <source>Fastest change of the feed override, in percent of the programmed feed per second</source>
        <translation>Schnellste Änderung des Vorschub-Overrides, in Prozent des programmierten Vorschubs je Sekunde</translation>
    </message>
    <message>
        <source>Recovery rate</source>
        <translation>Rückkehrrate</translation>
    </message>
    <message>
        <source>Rate of the way back toward 100 % when nothing chatters, as a share of the rate away from it</source>
        <translation>Rate des Rückwegs zu 100 %, wenn nichts rattert, als Anteil der Rate des Hinwegs</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Time constant of the low-pass on the wanted overrides</source>
        <translation>Zeitkonstante des Tiefpasses auf den gewünschten Overrides</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>Wanted changes up to this are not worth moving the machine</source>
        <translation>Gewünschte Änderungen bis hierher lohnen keine Bewegung der Maschine</translation>
    </message>
    <message>
        <source>Changes per minute</source>
        <translation>Änderungen je Minute</translation>
    </message>
    <message>
        <source>Moves that start from rest or turn back, at most so many in any minute</source>
        <translation>Bewegungen aus der Ruhe oder mit Umkehr, höchstens so viele in jeder Minute</translation>
    </message>
    <message>
        <source>Cool-down</source>
        <translation>Abkühlzeit</translation>
    </message>
    <message>
        <source>Pause after the changes per minute are used up; the second time Auto falls back to Advise</source>
        <translation>Pause, wenn die Änderungen je Minute verbraucht sind; beim zweiten Mal fällt Automatik auf Rat zurück</translation>
    </message>
    <message>
        <source>Speed tolerance</source>
        <translation>Drehzahltoleranz</translation>
    </message>
    <message>
        <source>The spindle counts as at speed, and an override as taken, within this</source>
        <translation>Innerhalb davon gilt die Drehzahl als erreicht und ein Override als angenommen</translation>
    </message>
    <message>
        <source>Machine state age</source>
        <translation>Alter des Maschinenzustands</translation>
    </message>
    <message>
        <source>Verdict age</source>
        <translation>Alter des Urteils</translation>
    </message>
    <message>
        <source>A verdict or request older than this is stale</source>
        <translation>Ein älteres Urteil oder eine ältere Anforderung ist veraltet</translation>
    </message>
    <message>
        <source>Hold before release</source>
        <translation>Halten vor dem Loslassen</translation>
    </message>
    <message>
        <source>On bad input the overrides are held this long, then the programmed values come back</source>
        <translation>Bei schlechten Eingaben werden die Overrides so lange gehalten, dann kommen die programmierten Werte zurück</translation>
    </message>
    <message>
        <source>Rest after release</source>
        <translation>Ruhe nach dem Loslassen</translation>
    </message>
    <message>
        <source>After a release the input must be good for this long before the overrides are taken again</source>
        <translation>Nach dem Loslassen müssen die Eingaben so lange gut sein, bevor die Overrides wieder genommen werden</translation>
    </message>
    <message>
        <source>Pause after the knob</source>
        <translation>Pause nach dem Drehknopf</translation>
    </message>
    <message>
        <source>After the operator turned a knob nothing new is asked this long</source>
        <translation>Nach einem Dreh des Bedieners wird so lange nichts Neues verlangt</translation>
    </message>
    <message>
        <source>Time to take an override</source>
        <translation>Zeit zum Annehmen eines Overrides</translation>
    </message>
    <message>
        <source>The override read back must agree with the command within this, or the machine is let go</source>
        <translation>Der zurückgelesene Override muss binnen dieser Zeit dem Befehl entsprechen, sonst wird die Maschine losgelassen</translation>
    </message>
    <message>
        <source>Time for the spindle to follow</source>
        <translation>Zeit für das Folgen der Spindel</translation>
    </message>
    <message>
        <source>The spindle must reach the commanded speed within this, or the machine is let go</source>
        <translation>Die Spindel muss die befohlene Drehzahl binnen dieser Zeit erreichen, sonst wird die Maschine losgelassen</translation>
    </message>
    <message>
        <source>Lease</source>
        <translation>Leihfrist</translation>
    </message>
    <message>
        <source>A command that is not renewed within this ends, and the programmed values come back</source>
        <translation>Ein Befehl, der nicht binnen dieser Zeit erneuert wird, endet, und die programmierten Werte kommen zurück</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>What is kept: everything, what surrounds events, or verdicts and indicators alone</source>
        <translation>Was aufgehoben wird: alles, das Umfeld von Ereignissen, oder nur Urteile und Kenngrößen</translation>
    </message>
    <message>
        <source>continuous</source>
        <translation>durchgehend</translation>
    </message>
    <message>
        <source>around-events</source>
        <translation>um Ereignisse</translation>
    </message>
    <message>
        <source>features</source>
        <translation>Kenngrößen</translation>
    </message>
    <message>
        <source>Kept before an event</source>
        <translation>Vor einem Ereignis</translation>
    </message>
    <message>
        <source>Around events: how much is kept from before each</source>
        <translation>Um Ereignisse: wie viel davor aufgehoben wird</translation>
    </message>
    <message>
        <source>Kept after an event</source>
        <translation>Nach einem Ereignis</translation>
    </message>
    <message>
        <source>Around events: how long recording goes on after the last</source>
        <translation>Um Ereignisse: wie lange nach dem letzten weiter aufgezeichnet wird</translation>
    </message>
    <message>
        <source>Step of the history</source>
        <translation>Schritt der Historie</translation>
    </message>
    <message>
        <source>Features: one step is kept in so long, and every one with an event</source>
        <translation>Kenngrößen: in so langer Zeit wird ein Schritt aufgehoben, und jeder mit einem Ereignis</translation>
    </message>
    <message>
        <source>Length of the history</source>
        <translation>Länge der Historie</translation>
    </message>
    <message>
        <source>Features: what is older goes</source>
        <translation>Kenngrößen: Älteres entfällt</translation>
    </message>
    <message>
        <source>Keep recordings for</source>
        <translation>Aufzeichnungen behalten für</translation>
    </message>
    <message>
        <source>Older recordings without a marker are deleted when a new one begins</source>
        <translation>Ältere Aufzeichnungen ohne Marke werden gelöscht, wenn eine neue beginnt</translation>
    </message>
    <message>
        <source>Keep recordings up to</source>
        <translation>Aufzeichnungen behalten bis</translation>
    </message>
    <message>
        <source>The oldest recordings without a marker are deleted beyond it</source>
        <translation>Darüber werden die ältesten Aufzeichnungen ohne Marke gelöscht</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Rückführung</translation>
    </message>
    <message>
        <source>In simulation: what is to fall, vibration by the accelerometers or the force at the spindle&apos;s frequency</source>
        <translation>In der Simulation: was kleiner werden soll, die Schwingung an den Beschleunigungsaufnehmern oder die Kraft bei der Spindelfrequenz</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Taps</source>
        <translation>Koeffizienten</translation>
    </message>
    <message>
        <source>Length of the adaptive filter of each axis (Ford 2013 table 3: 35)</source>
        <translation>Länge des adaptiven Filters je Achse (Ford 2013, Tabelle 3: 35)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Adaptation step mu; while &apos;normalised&apos; is on, as a fraction of the largest stable step</source>
        <translation>Adaptionsschritt mu; bei „normiert“ als Anteil des größten stabilen Schritts</translation>
    </message>
    <message>
        <source>Normalised</source>
        <translation>Normiert</translation>
    </message>
    <message>
        <source>Take the step as a fraction of the bound that follows the power of the filtered reference</source>
        <translation>Den Schritt als Anteil der Grenze nehmen, die der Leistung der gefilterten Referenz folgt</translation>
    </message>
    <message>
        <source>Leak</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>Factor on the weights at each sample (gamma of eq. 2); 1 forgets nothing</source>
        <translation>Faktor auf die Gewichte bei jedem Abtastwert (gamma aus Gl. 2); 1 vergisst nichts</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>What the filter works from: the error itself, or the disturbance as the model sees it</source>
        <translation>Womit das Filter arbeitet: dem Fehler selbst oder der Störung, wie das Modell sie sieht</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>internal-model</source>
        <translation>internes Modell</translation>
    </message>
    <message>
        <source>Path taps</source>
        <translation>Pfad-Koeffizienten</translation>
    </message>
    <message>
        <source>Length of each part of the recursive model from actuator to sensor (table 3: 35)</source>
        <translation>Länge jedes Teils des rekursiven Modells vom Aktor zum Sensor (Tabelle 3: 35)</translation>
    </message>
    <message>
        <source>Parametric</source>
        <translation>Parametrisch</translation>
    </message>
    <message>
        <source>Spectral line</source>
        <translation>Spektrallinie</translation>
    </message>
    <message>
        <source>Energy ratio</source>
        <translation>Energieanteil</translation>
    </message>
    <message>
        <source>Monitoring only</source>
        <translation>Nur Überwachung</translation>
    </message>
    <message>
        <source>Next stable pocket, checked</source>
        <translation>Nächster stabiler Bereich, geprüft</translation>
    </message>
    <message>
        <source>Centre of the lobe</source>
        <translation>Mitte des Bereichs</translation>
    </message>
    <message>
        <source>Toward less vibration</source>
        <translation>Zu weniger Schwingung</translation>
    </message>
    <message>
        <source>Least vibration</source>
        <translation>Kleinste Schwingung</translation>
    </message>
    <message>
        <source>Quarter wave between teeth</source>
        <translation>Viertelwelle zwischen Zähnen</translation>
    </message>
    <message>
        <source>Fuzzy speed and feed</source>
        <translation>Unscharf: Drehzahl und Vorschub</translation>
    </message>
    <message>
        <source>Fuzzy, learning its rules</source>
        <translation>Unscharf, lernt seine Regeln</translation>
    </message>
    <message>
        <source>Fuzzy, outputs tuned directly</source>
        <translation>Unscharf, Ausgänge direkt abgestimmt</translation>
    </message>
    <message>
        <source>The control of the simulated mill; the only one that takes commands from a replay</source>
        <translation>Die Steuerung der simulierten Fräse; die einzige, die Befehle einer Wiedergabe annimmt</translation>
    </message>
    <message>
        <source>LinuxCNC through linuxcncrsh and halrmt: host, port, hal_port</source>
        <translation>LinuxCNC über linuxcncrsh und halrmt: host, port, hal_port</translation>
    </message>
    <message>
        <source>GRBL 1.1 or grblHAL on a serial port or a host: device, baud; host, port</source>
        <translation>GRBL 1.1 oder grblHAL an serieller Schnittstelle oder Host: device, baud; host, port</translation>
    </message>
    <message>
        <source>A spindle drive or PLC by Modbus TCP or RTU: map, a file of registers</source>
        <translation>Ein Spindelantrieb oder eine SPS über Modbus TCP oder RTU: map, eine Registerdatei</translation>
    </message>
    <message>
        <source>Override voltages through a Comedi card: map, a file of calibration tables</source>
        <translation>Override-Spannungen über eine Comedi-Karte: map, eine Datei mit Kalibriertabellen</translation>
    </message>
    <message>
        <source>A simulated cut from a scenario file, in real time or as fast as possible</source>
        <translation>Ein simulierter Schnitt aus einer Szenariodatei, in Echtzeit oder so schnell wie möglich</translation>
    </message>
    <message>
        <source>Audio-class: measurement microphones, USB accelerometers, IEPE conditioners: device, rate_hz, bits, inputs</source>
        <translation>Audiogeräte: Messmikrofone, USB-Beschleunigungssensoren, IEPE-Verstärker: device, rate_hz, bits, inputs</translation>
    </message>
    <message>
        <source>Data acquisition cards, NI and many others: device, rate_hz, range, reference, inputs</source>
        <translation>Messkarten, NI und viele andere: device, rate_hz, range, reference, inputs</translation>
    </message>
    <message>
        <source>Accelerometers of Linux&apos; industrial I/O, here or through iiod: device, rate_hz, uri, inputs, trigger</source>
        <translation>Beschleunigungssensoren der Linux-Industrie-E/A, hier oder über iiod: device, rate_hz, uri, inputs, trigger</translation>
    </message>
    <message>
        <source>A microcontroller on a serial port, binary frames or text lines: device, baud, rate_hz, format</source>
        <translation>Ein Mikrocontroller an einer seriellen Schnittstelle, binäre Rahmen oder Textzeilen: device, baud, rate_hz, format</translation>
    </message>
    <message>
        <source>Several of these as one, aligned on the clock of the first: 1_id, 1_channels, 1_delay_ms, 2_id ...</source>
        <translation>Mehrere davon als eines, an der Uhr des ersten ausgerichtet: 1_id, 1_channels, 1_delay_ms, 2_id ...</translation>
    </message>
    <message>
        <source>A bridge that sends the same over a socket: host, port, rate_hz, format</source>
        <translation>Eine Brücke, die dasselbe über einen Socket sendet: host, port, rate_hz, format</translation>
    </message>
    <message>
        <source>Longest time per trial</source>
        <translation>Längste Zeit je Versuch</translation>
    </message>
    <message>
        <source>The vibration at each trial is averaged no longer than this</source>
        <translation>Die Schwingung wird je Versuch höchstens so lange gemittelt</translation>
    </message>
    <message>
        <source>Revolutions per trial</source>
        <translation>Umdrehungen je Versuch</translation>
    </message>
    <message>
        <source>The vibration at each trial is averaged over so many revolutions, or as long as is allowed</source>
        <translation>Die Schwingung wird je Versuch über so viele Umdrehungen gemittelt oder so lange wie erlaubt</translation>
    </message>
    <message>
        <source>Signal and cut</source>
        <translation>Signal und Schnitt</translation>
    </message>
    <message>
        <source>Limits of the machine</source>
        <translation>Grenzen der Maschine</translation>
    </message>
    <message>
        <source>Active work-holder</source>
        <translation>Aktive Spannvorrichtung</translation>
    </message>
    <message>
        <source>Emphasis</source>
        <translation>Betonung</translation>
    </message>
    <message>
        <source>How much more the error counts on the lines to quieten than elsewhere, as amplitudes; 1: no more</source>
        <translation>Um wie viel mehr der Fehler auf den zu beruhigenden Linien zählt als sonst, als Amplitude; 1: nicht mehr</translation>
    </message>
    <message>
        <source>Width of the emphasis</source>
        <translation>Breite der Betonung</translation>
    </message>
    <message>
        <source>Around each of the lines to quieten</source>
        <translation>Um jede der zu beruhigenden Linien</translation>
    </message>
    <message>
        <source>Excitation</source>
        <translation>Anregung</translation>
    </message>
    <message>
        <source>What moves the table while its paths are identified</source>
        <translation>Was den Tisch bewegt, während seine Strecken identifiziert werden</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>Gleitsinus</translation>
    </message>
    <message>
        <source>Level of identification</source>
        <translation>Pegel der Identifikation</translation>
    </message>
    <message>
        <source>Rms of the excitation, as a fraction of the stroke</source>
        <translation>Effektivwert der Anregung als Anteil des Hubs</translation>
    </message>
    <message>
        <source>Time of identification</source>
        <translation>Dauer der Identifikation</translation>
    </message>
    <message>
        <source>Length of the record it is made from</source>
        <translation>Länge der Aufzeichnung, aus der sie entsteht</translation>
    </message>
    <message>
        <source>Age of a model</source>
        <translation>Alter eines Modells</translation>
    </message>
    <message>
        <source>An older model of the path is not started with</source>
        <translation>Mit einem älteren Modell der Strecke wird nicht begonnen</translation>
    </message>
    <message>
        <source>Auxiliary noise</source>
        <translation>Hilfsrauschen</translation>
    </message>
    <message>
        <source>Rms of the noise that identifies the path anew while it controls, as a fraction of the stroke; 0: off</source>
        <translation>Effektivwert des Rauschens, das die Strecke während der Regelung neu identifiziert, als Anteil des Hubs; 0: aus</translation>
    </message>
    <message>
        <source>Frames of a block</source>
        <translation>Abtastungen je Block</translation>
    </message>
    <message>
        <source>In simulation: how many samples the device takes at a time</source>
        <translation>In der Simulation: wie viele Abtastungen das Gerät auf einmal nimmt</translation>
    </message>
    <message>
        <source>Peak of small</source>
        <translation>Spitze von klein</translation>
    </message>
    <message>
        <source>Where the coherence error is called small (NS, PS), of its whole range</source>
        <translation>Wo der Kohärenzfehler klein heißt (NS, PS), vom ganzen Bereich</translation>
    </message>
    <message>
        <source>Peak of medium</source>
        <translation>Spitze von mittel</translation>
    </message>
    <message>
        <source>Where the coherence error is called medium (NM, PM)</source>
        <translation>Wo der Kohärenzfehler mittel heißt (NM, PM)</translation>
    </message>
    <message>
        <source>Peak of big</source>
        <translation>Spitze von groß</translation>
    </message>
    <message>
        <source>Where the coherence error is called big (NB, PB)</source>
        <translation>Wo der Kohärenzfehler groß heißt (NB, PB)</translation>
    </message>
    <message>
        <source>Speed rule</source>
        <translation>Regel der Drehzahl</translation>
    </message>
    <message>
        <source>What this rule asks of the speed: 5 nothing, 1 down and 9 up at full (figure 3.7)</source>
        <translation>Was diese Regel von der Drehzahl verlangt: 5 nichts, 1 voll hinunter, 9 voll hinauf (Bild 3.7)</translation>
    </message>
    <message>
        <source>Feed rule</source>
        <translation>Regel des Vorschubs</translation>
    </message>
    <message>
        <source>What this rule asks of the feed: 5 nothing, 1 down and 9 up at full (figure 3.8)</source>
        <translation>Was diese Regel vom Vorschub verlangt: 5 nichts, 1 voll hinunter, 9 voll hinauf (Bild 3.8)</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Hal port</source>
        <translation>HAL-Port</translation>
    </message>
    <message>
        <source>Hal component port</source>
        <translation>Port der HAL-Komponente</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Adaptiver Vorschub</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Control password</source>
        <translation>Steuerpasswort</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>Baud</translation>
    </message>
    <message>
        <source>Reports in inches</source>
        <translation>Meldet in Zoll</translation>
    </message>
    <message>
        <source>Ask words</source>
        <translation>Modalwörter abfragen</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
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
        <translation>Eingänge</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Messbereich</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>common</source>
        <translation>gemeinsam</translation>
    </message>
    <message>
        <source>differential</source>
        <translation>differenziell</translation>
    </message>
    <message>
        <source>Uri</source>
        <translation>URI</translation>
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
        <translation>binär</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Sync</source>
        <translation>Synchronwort</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
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
        <translation>Zeitpunkte je Paket</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Abtastwert</translation>
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
        <translation>Bytefolge</translation>
    </message>
    <message>
        <source>little</source>
        <translation>little-endian</translation>
    </message>
    <message>
        <source>big</source>
        <translation>big-endian</translation>
    </message>
    <message>
        <source>Checksum</source>
        <translation>Prüfsumme</translation>
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
        <translation>Mit Zähler</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Schall</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Machine in inches</source>
        <translation>Maschine in Zoll</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Read the machine</source>
        <translation>Maschine lesen</translation>
    </message>
    <message>
        <source>Measure the delay</source>
        <translation>Verzögerung messen</translation>
    </message>
    <message>
        <source>What it can do</source>
        <translation>Was sie kann</translation>
    </message>
    <message>
        <source>serial port, for &apos;grbl&apos; or &apos;modbus&apos;</source>
        <translation>serieller Anschluss, für &apos;grbl&apos; oder &apos;modbus&apos;</translation>
    </message>
    <message>
        <source>linuxcncrsh, for &apos;linuxcnc&apos;</source>
        <translation>linuxcncrsh, für &apos;linuxcnc&apos;</translation>
    </message>
    <message>
        <source>halrmt, spindle speed for &apos;linuxcnc&apos;</source>
        <translation>halrmt, Spindeldrehzahl für &apos;linuxcnc&apos;</translation>
    </message>
    <message>
        <source>stillcut-hal, watchdog for &apos;linuxcnc&apos;</source>
        <translation>stillcut-hal, Watchdog für &apos;linuxcnc&apos;</translation>
    </message>
    <message>
        <source>Modbus server, for &apos;modbus&apos; with a map</source>
        <translation>Modbus-Server, für &apos;modbus&apos; mit Registertabelle</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>needs a label</source>
        <translation>braucht eine Bezeichnung</translation>
    </message>
    <message>
        <source>type one beside SPAN</source>
        <translation>eine neben BEREICH eintippen</translation>
    </message>
    <message>
        <source>export</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>the recording is still being read</source>
        <translation>die Aufnahme wird noch gelesen</translation>
    </message>
    <message>
        <source>a moment later</source>
        <translation>gleich noch einmal</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>active work-holder</source>
        <translation>aktive Spannvorrichtung</translation>
    </message>
    <message>
        <source>the last record is still being worked on</source>
        <translation>die letzte Aufnahme wird noch ausgewertet</translation>
    </message>
    <message>
        <source>score</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>nothing is marked here</source>
        <translation>hier ist nichts markiert</translation>
    </message>
    <message>
        <source>mark true and false alarms first</source>
        <translation>zuerst wahre und falsche Alarme markieren</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>there is no folder to keep it in</source>
        <translation>es gibt keinen Ordner dafür</translation>
    </message>
    <message>
        <source>letters and digits</source>
        <translation>Buchstaben und Ziffern</translation>
    </message>
    <message>
        <source>cannot be put in force here</source>
        <translation>lässt sich hier nicht in Kraft setzen</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>Vorführung</translation>
    </message>
    <message>
        <source>cannot run here</source>
        <translation>kann hier nicht laufen</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>there is no folder to keep them in</source>
        <translation>es gibt keinen Ordner dafür</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>the device has stopped</source>
        <translation>das Gerät ist stehen geblieben</translation>
    </message>
    <message>
        <source>this channel never moves</source>
        <translation>dieser Kanal bewegt sich nie</translation>
    </message>
    <message>
        <source>is the sensor connected?</source>
        <translation>ist der Sensor angeschlossen?</translation>
    </message>
    <message>
        <source>nothing is open</source>
        <translation>nichts ist geöffnet</translation>
    </message>
    <message>
        <source>replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>is no longer there</source>
        <translation>ist nicht mehr da</translation>
    </message>
    <message>
        <source>tune</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>there is no profile to keep them in</source>
        <translation>es gibt kein Profil dafür</translation>
    </message>
    <message>
        <source>start with --profile</source>
        <translation>mit --profile starten</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>the machine is under our authority</source>
        <translation>Stillcut hat das Kommando über die Maschine</translation>
    </message>
    <message>
        <source>set it to Off first</source>
        <translation>zuerst auf Aus stellen</translation>
    </message>
    <message>
        <source>Vibration limit</source>
        <translation>Grenze der Schwingung</translation>
    </message>
    <message>
        <source>Vibration (rms, SI unit of the first channel) from which the bar of the operator&apos;s page says that it is too much; auto: no limit</source>
        <translation>Schwingung (Effektivwert, SI-Einheit des ersten Kanals), ab der der Balken auf der Seite Bedienen sagt, dass sie zu groß ist; automatisch: keine Grenze</translation>
    </message>
    <message>
        <source>%1 answers</source>
        <translation>%1 antwortet</translation>
    </message>
    <message>
        <source>it answers, but its state is incomplete</source>
        <translation>sie antwortet, aber ihr Zustand ist unvollständig</translation>
    </message>
    <message>
        <source>the machine is off</source>
        <translation>die Maschine ist aus</translation>
    </message>
    <message>
        <source>the machine is in alarm</source>
        <translation>die Maschine steht auf Alarm</translation>
    </message>
    <message>
        <source>feed held</source>
        <translation>Vorschub angehalten</translation>
    </message>
    <message>
        <source>program running</source>
        <translation>Programm läuft</translation>
    </message>
    <message>
        <source>no program running</source>
        <translation>kein Programm läuft</translation>
    </message>
    <message>
        <source>spindle %1 rpm, programmed %2</source>
        <translation>Spindel %1 1/min, programmiert %2</translation>
    </message>
    <message>
        <source>overrides %1 % speed, %2 % feed</source>
        <translation>Override Drehzahl %1 %, Vorschub %2 %</translation>
    </message>
    <message>
        <source>locked by the program</source>
        <translation>vom Programm gesperrt</translation>
    </message>
    <message>
        <source>a look takes %1 ms, and what it shows is %2 ms old</source>
        <translation>eine Abfrage dauert %1 ms, was sie zeigt, ist %2 ms alt</translation>
    </message>
    <message>
        <source>%1 of %2 looks were lost</source>
        <translation>%1 von %2 Abfragen gingen verloren</translation>
    </message>
    <message>
        <source>speed %1 to %2 %, feed %3 to %4 %</source>
        <translation>Drehzahl %1 bis %2 %, Vorschub %3 bis %4 %</translation>
    </message>
    <message>
        <source>the machine goes back by itself when nothing comes from here</source>
        <translation>die Maschine geht von selbst zurück, wenn von hier nichts kommt</translation>
    </message>
    <message>
        <source>the machine has no watchdog: if this program dies, the overrides stay</source>
        <translation>die Maschine hat keinen Watchdog: stirbt dieses Programm, bleiben die Overrides stehen</translation>
    </message>
    <message>
        <source>one knock along %1: &apos;%2&apos; measured most, %3 dB above the next</source>
        <translation>ein Klopfen längs %1: &apos;%2&apos; hörte am meisten, %3 dB über dem nächsten</translation>
    </message>
    <message>
        <source>%4 knocks along %1: &apos;%2&apos; measured most, %3 dB above the next</source>
        <translation>%4 Klopfer längs %1: &apos;%2&apos; hörte am meisten, %3 dB über dem nächsten</translation>
    </message>
    <message>
        <source>it is right</source>
        <translation>es stimmt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; are exchanged</source>
        <translation>&apos;%1&apos; und &apos;%2&apos; sind vertauscht</translation>
    </message>
    <message>
        <source>A recording, in real time or at another pace: file, pace, rate_hz where the file does not say</source>
        <translation>Eine Aufzeichnung, in Echtzeit oder einem anderen Tempo: file, pace, rate_hz, wo die Datei sie nicht nennt</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>the device counts nothing: a loss of less than 30 ms or three blocks does not show, a longer one after a second or two</source>
        <translation>das Gerät zählt nicht mit: ein Verlust unter 30 ms oder drei Blöcken zeigt sich nicht, ein längerer nach ein bis zwei Sekunden</translation>
    </message>
    <message>
        <source>the card is not calibrated, its volts are nominal; comedi_soft_calibrate calibrates it</source>
        <translation>die Karte ist nicht kalibriert, ihre Volt sind Nennwerte; comedi_soft_calibrate kalibriert sie</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>is it there, and free?</source>
        <translation>ist es da und frei?</translation>
    </message>
    <message>
        <source>nothing is sent</source>
        <translation>es wird nichts gesendet</translation>
    </message>
    <message>
        <source>does the device stream?</source>
        <translation>sendet das Gerät?</translation>
    </message>
    <message>
        <source>bytes come, and no sample of the [[channels]] is in them</source>
        <translation>Bytes kommen an, aber kein Messwert der [[channels]] ist darin</translation>
    </message>
    <message>
        <source>are format, sync, sample, checksum, baud and the number of channels those of the sender?</source>
        <translation>sind format, sync, sample, checksum, baud und die Zahl der Kanäle die des Senders?</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>does not stream</source>
        <translation>liefert keinen Datenstrom</translation>
    </message>
    <message>
        <source>does not start</source>
        <translation>startet nicht</translation>
    </message>
    <message>
        <source>has no inputs that stream</source>
        <translation>hat keine Eingänge, die fortlaufend liefern</translation>
    </message>
    <message>
        <source>it may read single values only</source>
        <translation>vielleicht liest es nur Einzelwerte</translation>
    </message>
    <message>
        <source>it only shares its memory</source>
        <translation>es gibt nur seinen Speicher frei</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>does not take these settings together</source>
        <translation>nimmt diese Einstellungen nicht zusammen an</translation>
    </message>
    <message>
        <source>has not delivered enough in one piece</source>
        <translation>hat nicht genug am Stück geliefert</translation>
    </message>
    <message>
        <source>the device</source>
        <translation>das Gerät</translation>
    </message>
    <message>
        <source>%1 Hz cannot be measured at %2 samples a second</source>
        <translation>%1 Hz sind bei %2 Werten je Sekunde nicht zu hören</translation>
    </message>
    <message>
        <source>%1 MB are left</source>
        <translation>%1 MB sind frei</translation>
    </message>
    <message>
        <source>%1 [[channels]] in the profile</source>
        <translation>%1 [[channels]] im Profil</translation>
    </message>
    <message>
        <source>%1 and %2 frames</source>
        <translation>%1 und %2 Werte</translation>
    </message>
    <message>
        <source>%1 at %2: nothing comes any more, the wire is taken up again</source>
        <translation>%1 an %2: es kommt nichts mehr, die Leitung wird neu aufgenommen</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>%1 has no higher voltage</source>
        <translation>%1 hat keine höhere Spannung</translation>
    </message>
    <message>
        <source>%1 is longer than the file</source>
        <translation>%1 ist länger als die Datei</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1 is too large for a sample</source>
        <translation>%1 ist zu groß für einen Messwert</translation>
    </message>
    <message>
        <source>%1 mm is no depth</source>
        <translation>%1 mm ist keine Schnitttiefe</translation>
    </message>
    <message>
        <source>%1 of %2 bytes are there; copy it again</source>
        <translation>%1 von %2 Bytes sind da; bitte neu kopieren</translation>
    </message>
    <message>
        <source>%1 rpm is no speed</source>
        <translation>%1 1/min ist keine Drehzahl</translation>
    </message>
    <message>
        <source>%1 rpm is too low for these modes</source>
        <translation>%1 1/min ist zu langsam für diese Moden</translation>
    </message>
    <message>
        <source>%1 turns the table round</source>
        <translation>%1 kehrt die Tabelle um</translation>
    </message>
    <message>
        <source>%1, device %2: %3</source>
        <translation>%1, Gerät %2: %3</translation>
    </message>
    <message>
        <source>%1: %2 failed (%3)</source>
        <translation>%1: %2 misslungen (%3)</translation>
    </message>
    <message>
        <source>%1: a length inside it is wrong</source>
        <translation>%1: eine Länge darin ist falsch</translation>
    </message>
    <message>
        <source>%1: is not the device that it was</source>
        <translation>%1: ist nicht mehr dasselbe Gerät</translation>
    </message>
    <message>
        <source>%1; some devices need a &apos;trigger&apos;</source>
        <translation>%1; manche Geräte brauchen einen „trigger“</translation>
    </message>
    <message>
        <source>%1; stillcut-cli devices lists what there is</source>
        <translation>%1; stillcut-cli devices zählt auf, was da ist</translation>
    </message>
    <message>
        <source>%1; the cut before has been stopped</source>
        <translation>%1; der Schnitt davor wurde beendet</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; measured it within %3 dB of each other</source>
        <translation>„%1“ und „%2“ hörten es mit weniger als %3 dB Unterschied</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be opened</source>
        <translation>„%1“ lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read</source>
        <translation>„%1“ lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no other axis beside it</source>
        <translation>„%1“ hat keine zweite Achse neben sich</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither true nor false</source>
        <translation>„%1“ ist weder true noch false</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no delay</source>
        <translation>„%1“ ist keine Verzögerung</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no name for a file</source>
        <translation>„%1“ ist kein Dateiname</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none</source>
        <translation>„%1“ ist keine</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not KEY=VALUE</source>
        <translation>„%1“ ist nicht KEY=VALUE</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a choice</source>
        <translation>„%1“ steht nicht zur Wahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a time and a speed</source>
        <translation>„%1“ ist keine Zeit mit Drehzahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known</source>
        <translation>„%1“ ist unbekannt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; promises more numbers than the file holds</source>
        <translation>„%1“ verspricht mehr Zahlen, als die Datei enthält</translation>
    </message>
    <message>
        <source>&apos;%1channels&apos; is %2</source>
        <translation>„%1channels“ ist %2</translation>
    </message>
    <message>
        <source>&apos;adaptive_feed&apos; needs &apos;hal_component_port&apos;</source>
        <translation>„adaptive_feed“ braucht „hal_component_port“</translation>
    </message>
    <message>
        <source>&apos;full_stroke_um&apos; is less</source>
        <translation>„full_stroke_um“ ist kleiner</translation>
    </message>
    <message>
        <source>&apos;input_x&apos; and &apos;input_y&apos;</source>
        <translation>„input_x“ und „input_y“</translation>
    </message>
    <message>
        <source>&apos;map&apos; is missing</source>
        <translation>„map“ fehlt</translation>
    </message>
    <message>
        <source>&apos;output_x&apos; and &apos;output_y&apos;</source>
        <translation>„output_x“ und „output_y“</translation>
    </message>
    <message>
        <source>&apos;rate_hz&apos; = %1 is not among its rates</source>
        <translation>„rate_hz“ = %1 gehört nicht zu seinen Raten</translation>
    </message>
    <message>
        <source>&apos;rms&apos; must be above 0 and at most 0.3 of the stroke</source>
        <translation>„rms“ muss über 0 und höchstens 0,3 des Hubs sein</translation>
    </message>
    <message>
        <source>&apos;source.id&apos; is missing</source>
        <translation>„source.id“ fehlt</translation>
    </message>
    <message>
        <source>&apos;stroke_um&apos; is more than the output can drive</source>
        <translation>„stroke_um“ ist mehr, als der Ausgang schafft</translation>
    </message>
    <message>
        <source>/24 or a larger number</source>
        <translation>/24 oder eine größere Zahl</translation>
    </message>
    <message>
        <source>0 to 1000000 rpm</source>
        <translation>0 bis 1000000 1/min</translation>
    </message>
    <message>
        <source>1 to 32 sensors are needed</source>
        <translation>1 bis 32 Sensoren sind nötig</translation>
    </message>
    <message>
        <source>1 to 64 channels and a rate above zero were expected</source>
        <translation>1 bis 64 Kanäle und eine Rate über null wurden erwartet</translation>
    </message>
    <message>
        <source>1_id, 1_channels, 1_delay_ms and 1_ with the device&apos;s own settings, then 2_</source>
        <translation>1_id, 1_channels, 1_delay_ms und 1_ mit den Einstellungen des Geräts, dann 2_</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>Verbindung abgebrochen</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Verbindung abgelehnt; läuft die Gegenstelle?</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>Zeit für die Verbindung abgelaufen; Adresse und Kabel prüfen</translation>
    </message>
    <message>
        <source>DEC and IBM formats are not read</source>
        <translation>DEC- und IBM-Formate werden nicht gelesen</translation>
    </message>
    <message>
        <source>Delta_X holds &apos;%1&apos;</source>
        <translation>Delta_X enthält „%1“</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Belegt: ein anderes Programm hat es offen</translation>
    </message>
    <message>
        <source>FLAC holds at most 8 channels</source>
        <translation>FLAC fasst höchstens 8 Kanäle</translation>
    </message>
    <message>
        <source>Format not recognised.</source>
        <translation>Format nicht erkannt.</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler; Kabel und Gerät prüfen</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Ist ein Ordner</translation>
    </message>
    <message>
        <source>Modbus is not part of this build</source>
        <translation>Modbus gehört nicht zu diesem Programmbau</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>Kein Weg zum Rechner; Netz und Adresse prüfen</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Kein Platz mehr auf dem Datenträger; Platz schaffen</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>Gerät gibt es nicht; ist es angeschlossen?</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>Gerät oder Adresse gibt es nicht; ist es angeschlossen?</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Ist kein Ordner</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Keine Berechtigung; Besitzer und Rechte prüfen</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Datenträger ist schreibgeschützt</translation>
    </message>
    <message>
        <source>SI units per device unit</source>
        <translation>SI-Einheiten je Geräteeinheit</translation>
    </message>
    <message>
        <source>Stillcut session</source>
        <translation>Stillcut-Sitzung</translation>
    </message>
    <message>
        <source>Supported file format but file is malformed.</source>
        <translation>Das Format ist bekannt, aber die Datei ist fehlerhaft.</translation>
    </message>
    <message>
        <source>Supported file format but unsupported encoding.</source>
        <translation>Das Format ist bekannt, aber die Kodierung nicht.</translation>
    </message>
    <message>
        <source>System error.</source>
        <translation>Systemfehler.</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Zu viele offene Dateien</translation>
    </message>
    <message>
        <source>[cut] speed_rpm or feed_mm_min is missing</source>
        <translation>[cut] speed_rpm oder feed_mm_min fehlt</translation>
    </message>
    <message>
        <source>a block has %1 channels</source>
        <translation>ein Block hat %1 Kanäle</translation>
    </message>
    <message>
        <source>a block needs at least one frame</source>
        <translation>ein Block braucht mindestens einen Wert</translation>
    </message>
    <message>
        <source>a coil or discrete input is one bit</source>
        <translation>ein Coil oder Discrete Input ist ein Bit</translation>
    </message>
    <message>
        <source>a cutting speed cannot be limited without the tool&apos;s diameter</source>
        <translation>ohne Werkzeugdurchmesser lässt sich die Schnittgeschwindigkeit nicht begrenzen</translation>
    </message>
    <message>
        <source>a damaged file</source>
        <translation>eine beschädigte Datei</translation>
    </message>
    <message>
        <source>a damaged or truncated file</source>
        <translation>eine beschädigte oder abgeschnittene Datei</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>ein Gerät</translation>
    </message>
    <message>
        <source>a finite number was expected</source>
        <translation>eine endliche Zahl wurde erwartet</translation>
    </message>
    <message>
        <source>a gap of %1 s</source>
        <translation>eine Lücke von %1 s</translation>
    </message>
    <message>
        <source>a history of features; detectors need the samples themselves</source>
        <translation>ein Verlauf von Merkmalen; Detektoren brauchen die Messwerte selbst</translation>
    </message>
    <message>
        <source>a path cannot be taken over while the table moves</source>
        <translation>ein Pfad lässt sich nicht übernehmen, solange der Tisch sich bewegt</translation>
    </message>
    <message>
        <source>a quarter of a revolution must fit into 512 samples</source>
        <translation>eine Viertelumdrehung muss in 512 Werte passen</translation>
    </message>
    <message>
        <source>a range is two numbers, lowest and highest</source>
        <translation>ein Bereich sind zwei Zahlen, kleinste und größte</translation>
    </message>
    <message>
        <source>a recording of this name is still being written, or was cut off; take another name</source>
        <translation>eine Aufzeichnung dieses Namens wird noch geschrieben oder wurde abgebrochen; anderen Namen nehmen</translation>
    </message>
    <message>
        <source>a run needs a device</source>
        <translation>ein Lauf braucht ein Gerät</translation>
    </message>
    <message>
        <source>a scenario is needed</source>
        <translation>ein Szenario ist nötig</translation>
    </message>
    <message>
        <source>a second segment of the measurement begins</source>
        <translation>ein zweiter Abschnitt der Messung beginnt</translation>
    </message>
    <message>
        <source>a sensor needs a name</source>
        <translation>ein Sensor braucht einen Namen</translation>
    </message>
    <message>
        <source>a session, or a recording of any kind that is imported</source>
        <translation>eine Sitzung oder eine Aufzeichnung, die importiert werden kann</translation>
    </message>
    <message>
        <source>a simulated or recorded cut may not drive a real machine</source>
        <translation>ein simulierter oder aufgezeichneter Schnitt darf keine echte Maschine steuern</translation>
    </message>
    <message>
        <source>a table is missing or has another layout</source>
        <translation>eine Tabelle fehlt oder ist anders aufgebaut</translation>
    </message>
    <message>
        <source>a time step above zero was expected</source>
        <translation>ein Zeitschritt über null wurde erwartet</translation>
    </message>
    <message>
        <source>a truncated file, or its header is wrong</source>
        <translation>eine abgeschnittene Datei, oder ihr Kopf ist falsch</translation>
    </message>
    <message>
        <source>a truncated or damaged file</source>
        <translation>eine abgeschnittene oder beschädigte Datei</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>ein Wert liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>a value must belong to one voltage</source>
        <translation>ein Wert muss zu einer Spannung gehören</translation>
    </message>
    <message>
        <source>above 0 and up to 1000 mm</source>
        <translation>über 0 und bis 1000 mm</translation>
    </message>
    <message>
        <source>above 0 and up to 1e6 rpm</source>
        <translation>über 0 und bis 1e6 1/min</translation>
    </message>
    <message>
        <source>active &apos;alsa&apos;</source>
        <translation>aktiv „alsa“</translation>
    </message>
    <message>
        <source>actuator</source>
        <translation>Aktor</translation>
    </message>
    <message>
        <source>all are time, indicators or empty</source>
        <translation>alle sind Zeit, Kennwerte oder leer</translation>
    </message>
    <message>
        <source>allowed: %1 and above</source>
        <translation>erlaubt: %1 und mehr</translation>
    </message>
    <message>
        <source>allowed: %1 to %2</source>
        <translation>erlaubt: %1 bis %2</translation>
    </message>
    <message>
        <source>allowed: up to %1</source>
        <translation>erlaubt: bis %1</translation>
    </message>
    <message>
        <source>an echo is two numbers, delay in ms and gain</source>
        <translation>ein Echo sind zwei Zahlen, Verzögerung in ms und Verstärkung</translation>
    </message>
    <message>
        <source>an echo&apos;s delay must lie between 0 and 1 s</source>
        <translation>die Verzögerung eines Echos muss zwischen 0 und 1 s liegen</translation>
    </message>
    <message>
        <source>analog outputs are not part of this build</source>
        <translation>analoge Ausgänge gehören nicht zu diesem Programmbau</translation>
    </message>
    <message>
        <source>angles above zero, 360 degrees together</source>
        <translation>Winkel über null, zusammen 360 Grad</translation>
    </message>
    <message>
        <source>announces %1 bytes, but its points take %2</source>
        <translation>kündigt %1 Bytes an, aber seine Punkte brauchen %2</translation>
    </message>
    <message>
        <source>announces %1 points, more than the file holds</source>
        <translation>kündigt %1 Punkte an, mehr als die Datei enthält</translation>
    </message>
    <message>
        <source>as 192.168.1.0/24</source>
        <translation>wie 192.168.1.0/24</translation>
    </message>
    <message>
        <source>as many as the device sends, 1 to %1</source>
        <translation>so viele, wie das Gerät sendet, 1 bis %1</translation>
    </message>
    <message>
        <source>at least %1 samples</source>
        <translation>mindestens %1 Werte</translation>
    </message>
    <message>
        <source>at least one mode is needed</source>
        <translation>mindestens eine Mode ist nötig</translation>
    </message>
    <message>
        <source>at most %1 frequencies above 0, for example 339, 1024</source>
        <translation>höchstens %1 Frequenzen über 0, zum Beispiel 339, 1024</translation>
    </message>
    <message>
        <source>at most %1 modes can be simulated</source>
        <translation>höchstens %1 Moden lassen sich simulieren</translation>
    </message>
    <message>
        <source>at most 31, 63 and 511 bytes</source>
        <translation>höchstens 31, 63 und 511 Bytes</translation>
    </message>
    <message>
        <source>at most 8</source>
        <translation>höchstens 8</translation>
    </message>
    <message>
        <source>at point %1</source>
        <translation>bei Punkt %1</translation>
    </message>
    <message>
        <source>axis must be x or y</source>
        <translation>axis muss x oder y sein</translation>
    </message>
    <message>
        <source>binary frames begin with 1 to 8 bytes in hexadecimal, for example AA55</source>
        <translation>binäre Rahmen beginnen mit 1 bis 8 Bytes hexadezimal, zum Beispiel AA55</translation>
    </message>
    <message>
        <source>block frames must lie between 1 and 65536</source>
        <translation>die Blocklänge muss zwischen 1 und 65536 liegen</translation>
    </message>
    <message>
        <source>blocks of %1 frames are too long</source>
        <translation>Blöcke von %1 Werten sind zu lang</translation>
    </message>
    <message>
        <source>blocks were lost since the record was made</source>
        <translation>seit der Aufnahme gingen Blöcke verloren</translation>
    </message>
    <message>
        <source>blocks were lost, and input and output of this device do not start together</source>
        <translation>Blöcke gingen verloren, und Ein- und Ausgang dieses Geräts beginnen nicht gemeinsam</translation>
    </message>
    <message>
        <source>byte order, format, lines, bytes</source>
        <translation>Bytefolge, Format, Zeilen, Bytes</translation>
    </message>
    <message>
        <source>cannot be decided again</source>
        <translation>lässt sich nicht neu entscheiden</translation>
    </message>
    <message>
        <source>cannot be drawn so</source>
        <translation>lässt sich so nicht zeichnen</translation>
    </message>
    <message>
        <source>cannot be marked: the journal beside it belongs to another recording, or is in use</source>
        <translation>lässt sich nicht markieren: das Journal daneben gehört zu einer anderen Aufzeichnung oder wird benutzt</translation>
    </message>
    <message>
        <source>cannot be opened for %1</source>
        <translation>lässt sich nicht für %1 öffnen</translation>
    </message>
    <message>
        <source>cannot be recorded</source>
        <translation>lässt sich nicht aufzeichnen</translation>
    </message>
    <message>
        <source>cannot identify while the table moves</source>
        <translation>keine Identifikation, solange der Tisch sich bewegt</translation>
    </message>
    <message>
        <source>cannot stream at a rate</source>
        <translation>kann nicht mit fester Rate liefern</translation>
    </message>
    <message>
        <source>channels, block length or rate</source>
        <translation>Kanäle, Blocklänge oder Rate</translation>
    </message>
    <message>
        <source>channels, rate and block length must be known before</source>
        <translation>Kanäle, Rate und Blocklänge müssen vorher bekannt sein</translation>
    </message>
    <message>
        <source>check the machine&apos;s profile</source>
        <translation>Profil der Maschine prüfen</translation>
    </message>
    <message>
        <source>choices: %1</source>
        <translation>zur Wahl: %1</translation>
    </message>
    <message>
        <source>choices: acceleration, velocity, displacement, sound, force, current, speed</source>
        <translation>zur Wahl: acceleration, velocity, displacement, sound, force, current, speed</translation>
    </message>
    <message>
        <source>choices: iepe, ac, dc</source>
        <translation>zur Wahl: iepe, ac, dc</translation>
    </message>
    <message>
        <source>choose some with --channel N[,N]</source>
        <translation>mit --channel N[,N] einige auswählen</translation>
    </message>
    <message>
        <source>coil or holding</source>
        <translation>coil oder holding</translation>
    </message>
    <message>
        <source>column %1 holds %2</source>
        <translation>Spalte %1 enthält %2</translation>
    </message>
    <message>
        <source>configure with STILLCUT_DESKTOP=ON</source>
        <translation>mit STILLCUT_DESKTOP=ON bauen</translation>
    </message>
    <message>
        <source>convert to CSV instead, or a span without it</source>
        <translation>stattdessen nach CSV umwandeln oder einen Abschnitt ohne sie</translation>
    </message>
    <message>
        <source>could not be repaired</source>
        <translation>ließ sich nicht reparieren</translation>
    </message>
    <message>
        <source>cutting coefficients must be finite</source>
        <translation>Schnittkoeffizienten müssen endlich sein</translation>
    </message>
    <message>
        <source>damping ratio must lie between 0 and 1</source>
        <translation>der Dämpfungsgrad muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>detector</source>
        <translation>Detektor</translation>
    </message>
    <message>
        <source>diameter must be above zero</source>
        <translation>der Durchmesser muss über null liegen</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;?</source>
        <translation>war „%1“ gemeint?</translation>
    </message>
    <message>
        <source>direction must not be zero</source>
        <translation>die Richtung darf nicht null sein</translation>
    </message>
    <message>
        <source>does not end after its %1 points</source>
        <translation>endet nicht nach seinen %1 Punkten</translation>
    </message>
    <message>
        <source>does not go once around</source>
        <translation>geht nicht einmal herum</translation>
    </message>
    <message>
        <source>does not hold 100 %</source>
        <translation>enthält nicht 100 %</translation>
    </message>
    <message>
        <source>does not take the trigger &apos;%1&apos;</source>
        <translation>nimmt den Trigger „%1“ nicht an</translation>
    </message>
    <message>
        <source>does not tell its range</source>
        <translation>nennt seinen Bereich nicht</translation>
    </message>
    <message>
        <source>does the calibrator run, on this channel, and is the machine quiet?</source>
        <translation>läuft der Kalibrator, auf diesem Kanal, und ist die Maschine still?</translation>
    </message>
    <message>
        <source>duration must lie between 0 and 3600 s</source>
        <translation>die Dauer muss zwischen 0 und 3600 s liegen</translation>
    </message>
    <message>
        <source>each override has an output of its own</source>
        <translation>jeder Override hat einen eigenen Ausgang</translation>
    </message>
    <message>
        <source>ended before the record was whole</source>
        <translation>endete, bevor die Aufnahme vollständig war</translation>
    </message>
    <message>
        <source>ends after %1 of %2 frames</source>
        <translation>endet nach %1 von %2 Werten</translation>
    </message>
    <message>
        <source>ends after %1 of %2 points</source>
        <translation>endet nach %1 von %2 Punkten</translation>
    </message>
    <message>
        <source>ends before it begins</source>
        <translation>endet, bevor es beginnt</translation>
    </message>
    <message>
        <source>ends early</source>
        <translation>endet zu früh</translation>
    </message>
    <message>
        <source>every value must be above zero</source>
        <translation>jeder Wert muss über null liegen</translation>
    </message>
    <message>
        <source>every value would be the offset</source>
        <translation>jeder Wert wäre der Nullpunkt</translation>
    </message>
    <message>
        <source>exponent must lie in (0, 1]</source>
        <translation>der Exponent muss in (0, 1] liegen</translation>
    </message>
    <message>
        <source>feed lag must lie between 0 and 10 s</source>
        <translation>die Vorschubverzögerung muss zwischen 0 und 10 s liegen</translation>
    </message>
    <message>
        <source>feed per tooth must lie between 0 and 10 mm</source>
        <translation>der Zahnvorschub muss zwischen 0 und 10 mm liegen</translation>
    </message>
    <message>
        <source>feed per tooth must not be negative</source>
        <translation>der Zahnvorschub darf nicht negativ sein</translation>
    </message>
    <message>
        <source>fits no path</source>
        <translation>passt zu keinem Pfad</translation>
    </message>
    <message>
        <source>for example energy-ratio.chatter=0.2</source>
        <translation>zum Beispiel energy-ratio.chatter=0.2</translation>
    </message>
    <message>
        <source>force feedback needs one per axis</source>
        <translation>Kraftrückführung braucht einen je Achse</translation>
    </message>
    <message>
        <source>frame %1 of channel %2 is not a finite number</source>
        <translation>Wert %1 von Kanal %2 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>frequency must be above zero</source>
        <translation>die Frequenz muss über null liegen</translation>
    </message>
    <message>
        <source>from must lie before to, with 1 to 65536 columns</source>
        <translation>from muss vor to liegen, mit 1 bis 65536 Spalten</translation>
    </message>
    <message>
        <source>gain must not be zero</source>
        <translation>die Verstärkung darf nicht null sein</translation>
    </message>
    <message>
        <source>give --rate HZ to read the rows as evenly spaced</source>
        <translation>mit --rate HZ werden die Zeilen als gleichabständig gelesen</translation>
    </message>
    <message>
        <source>give --rate HZ to read the samples as evenly spaced</source>
        <translation>mit --rate HZ werden die Werte als gleichabständig gelesen</translation>
    </message>
    <message>
        <source>give it with --rate HZ</source>
        <translation>mit --rate HZ angeben</translation>
    </message>
    <message>
        <source>give the diameter or set it to auto</source>
        <translation>Durchmesser angeben oder auf auto setzen</translation>
    </message>
    <message>
        <source>half a second at most</source>
        <translation>höchstens eine halbe Sekunde</translation>
    </message>
    <message>
        <source>has %1 channels at %2 Hz</source>
        <translation>hat %1 Kanäle mit %2 Hz</translation>
    </message>
    <message>
        <source>has %1 columns where %2 were expected</source>
        <translation>hat %1 Spalten, wo %2 erwartet wurden</translation>
    </message>
    <message>
        <source>has a row of %1 numbers</source>
        <translation>hat eine Zeile mit %1 Zahlen</translation>
    </message>
    <message>
        <source>has different periods for input and output</source>
        <translation>hat verschiedene Perioden für Ein- und Ausgang</translation>
    </message>
    <message>
        <source>has fewer than two points</source>
        <translation>hat weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>has more numbers than its %1 points</source>
        <translation>hat mehr Zahlen als seine %1 Punkte</translation>
    </message>
    <message>
        <source>has more than 256 columns</source>
        <translation>hat mehr als 256 Spalten</translation>
    </message>
    <message>
        <source>has more than 64 channels</source>
        <translation>hat mehr als 64 Kanäle</translation>
    </message>
    <message>
        <source>has no %1 Hz (%2)</source>
        <translation>hat keine %1 Hz (%2)</translation>
    </message>
    <message>
        <source>has no %1 channels (%2)</source>
        <translation>hat keine %1 Kanäle (%2)</translation>
    </message>
    <message>
        <source>has no %1 channels (&apos;inputs&apos;)</source>
        <translation>hat keine %1 Kanäle („inputs“)</translation>
    </message>
    <message>
        <source>has no active work-holder</source>
        <translation>hat keinen aktiven Werkstückhalter</translation>
    </message>
    <message>
        <source>has no channel %1</source>
        <translation>hat keinen Kanal %1</translation>
    </message>
    <message>
        <source>has no column &apos;%1&apos;</source>
        <translation>hat keine Spalte „%1“</translation>
    </message>
    <message>
        <source>has no end</source>
        <translation>hat kein Ende</translation>
    </message>
    <message>
        <source>has no input %1 (&apos;inputs&apos;)</source>
        <translation>hat keinen Eingang %1 („inputs“)</translation>
    </message>
    <message>
        <source>has no marker %1</source>
        <translation>hat keine Marke %1</translation>
    </message>
    <message>
        <source>has no marker &apos;%1&apos;</source>
        <translation>hat keine Marke „%1“</translation>
    </message>
    <message>
        <source>has no range %1 (&apos;range&apos;)</source>
        <translation>hat keinen Bereich %1 („range“)</translation>
    </message>
    <message>
        <source>has no samples of %1 bits (&apos;bits&apos;)</source>
        <translation>hat keine Werte mit %1 Bit („bits“)</translation>
    </message>
    <message>
        <source>has no samples of 32 bits (%1)</source>
        <translation>hat keine Werte mit 32 Bit (%1)</translation>
    </message>
    <message>
        <source>has the channel of &apos;speed&apos;</source>
        <translation>hat den Kanal von „speed“</translation>
    </message>
    <message>
        <source>header inconsistent</source>
        <translation>Kopf widersprüchlich</translation>
    </message>
    <message>
        <source>helix must lie within 80 degrees</source>
        <translation>der Drall muss innerhalb von 80 Grad liegen</translation>
    </message>
    <message>
        <source>helix slices must lie between 1 and 200</source>
        <translation>die Drallscheiben müssen zwischen 1 und 200 liegen</translation>
    </message>
    <message>
        <source>hold sensor and calibrator still</source>
        <translation>Sensor und Kalibrator ruhig halten</translation>
    </message>
    <message>
        <source>holds %1 data sets in several places</source>
        <translation>enthält %1 Datensätze an mehreren Stellen</translation>
    </message>
    <message>
        <source>holds a row that is not all finite numbers</source>
        <translation>enthält eine Zeile, die nicht nur endliche Zahlen hat</translation>
    </message>
    <message>
        <source>holds a value that is not finite</source>
        <translation>enthält einen Wert, der nicht endlich ist</translation>
    </message>
    <message>
        <source>holds bytes that are no text</source>
        <translation>enthält Bytes, die kein Text sind</translation>
    </message>
    <message>
        <source>holds fewer bytes than it announces</source>
        <translation>enthält weniger Bytes als angekündigt</translation>
    </message>
    <message>
        <source>holds more than 4096 channels</source>
        <translation>enthält mehr als 4096 Kanäle</translation>
    </message>
    <message>
        <source>holds more than 4096 objects</source>
        <translation>enthält mehr als 4096 Objekte</translation>
    </message>
    <message>
        <source>holds more than 4096 variables</source>
        <translation>enthält mehr als 4096 Variablen</translation>
    </message>
    <message>
        <source>holds no array of samples</source>
        <translation>enthält kein Feld von Messwerten</translation>
    </message>
    <message>
        <source>holds no data set of numbers</source>
        <translation>enthält keinen Datensatz mit Zahlen</translation>
    </message>
    <message>
        <source>holds no dataset 58</source>
        <translation>enthält keinen Datensatz 58</translation>
    </message>
    <message>
        <source>holds no samples</source>
        <translation>enthält keine Messwerte</translation>
    </message>
    <message>
        <source>holds no speeds</source>
        <translation>enthält keine Drehzahlen</translation>
    </message>
    <message>
        <source>holds no time recording</source>
        <translation>enthält keine Zeitaufzeichnung</translation>
    </message>
    <message>
        <source>holds no truth</source>
        <translation>enthält keine Wahrheit</translation>
    </message>
    <message>
        <source>holds no variable that can be read</source>
        <translation>enthält keine lesbare Variable</translation>
    </message>
    <message>
        <source>holds something that is not a finite number</source>
        <translation>enthält etwas, das keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>holds something that is not a text</source>
        <translation>enthält etwas, das kein Text ist</translation>
    </message>
    <message>
        <source>holds times that are not finite</source>
        <translation>enthält Zeiten, die nicht endlich sind</translation>
    </message>
    <message>
        <source>identification</source>
        <translation>Identifikation</translation>
    </message>
    <message>
        <source>identify first</source>
        <translation>erst identifizieren</translation>
    </message>
    <message>
        <source>identify it again</source>
        <translation>neu identifizieren</translation>
    </message>
    <message>
        <source>identify it first</source>
        <translation>erst identifizieren</translation>
    </message>
    <message>
        <source>input %1 has %2 bits in %3</source>
        <translation>Eingang %1 hat %2 Bit in %3</translation>
    </message>
    <message>
        <source>input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>install %1 and build again</source>
        <translation>%1 installieren und neu bauen</translation>
    </message>
    <message>
        <source>install libcomedi-dev and build again</source>
        <translation>libcomedi-dev installieren und neu bauen</translation>
    </message>
    <message>
        <source>is 0</source>
        <translation>ist 0</translation>
    </message>
    <message>
        <source>is 2</source>
        <translation>ist 2</translation>
    </message>
    <message>
        <source>is a folder, not a recording</source>
        <translation>ist ein Ordner, keine Aufzeichnung</translation>
    </message>
    <message>
        <source>is a session of version %1</source>
        <translation>ist eine Sitzung der Version %1</translation>
    </message>
    <message>
        <source>is an HDF5 file, but not a Stillcut session</source>
        <translation>ist eine HDF5-Datei, aber keine Stillcut-Sitzung</translation>
    </message>
    <message>
        <source>is being written already</source>
        <translation>wird schon geschrieben</translation>
    </message>
    <message>
        <source>is cut short: its end is missing</source>
        <translation>ist abgeschnitten: das Ende fehlt</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is given beside &apos;device&apos;</source>
        <translation>steht neben „device“</translation>
    </message>
    <message>
        <source>is given beside sensitivity_mv</source>
        <translation>steht neben sensitivity_mv</translation>
    </message>
    <message>
        <source>is halrmt running there?</source>
        <translation>läuft dort halrmt?</translation>
    </message>
    <message>
        <source>is it connected?</source>
        <translation>ist er angeschlossen?</translation>
    </message>
    <message>
        <source>is larger than 16 MB: no file of settings</source>
        <translation>ist größer als 16 MB: keine Einstellungsdatei</translation>
    </message>
    <message>
        <source>is later than on-line identification looks, %1 samples</source>
        <translation>kommt später, als die laufende Identifikation schaut, %1 Werte</translation>
    </message>
    <message>
        <source>is linuxcncrsh running there?</source>
        <translation>läuft dort linuxcncrsh?</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is missing or no object in JSON</source>
        <translation>fehlt oder ist kein Objekt in JSON</translation>
    </message>
    <message>
        <source>is missing, and so is &apos;feed&apos;</source>
        <translation>fehlt, und „feed“ ebenso</translation>
    </message>
    <message>
        <source>is more than 256 addresses</source>
        <translation>sind mehr als 256 Adressen</translation>
    </message>
    <message>
        <source>is neither true nor false</source>
        <translation>ist weder true noch false</translation>
    </message>
    <message>
        <source>is no MATLAB file of version 5 or 7</source>
        <translation>ist keine MATLAB-Datei der Version 5 oder 7</translation>
    </message>
    <message>
        <source>is no MATLAB file of version 5 to 7.3</source>
        <translation>ist keine MATLAB-Datei der Version 5 bis 7.3</translation>
    </message>
    <message>
        <source>is no gap of the recording beside it</source>
        <translation>ist keine Lücke der Aufzeichnung daneben</translation>
    </message>
    <message>
        <source>is no lobe case</source>
        <translation>ist kein Stabilitätsfall</translation>
    </message>
    <message>
        <source>is no session</source>
        <translation>ist keine Sitzung</translation>
    </message>
    <message>
        <source>is no session file</source>
        <translation>ist keine Sitzungsdatei</translation>
    </message>
    <message>
        <source>is no sound file that can be read</source>
        <translation>ist keine lesbare Tondatei</translation>
    </message>
    <message>
        <source>is no subnet</source>
        <translation>ist kein Teilnetz</translation>
    </message>
    <message>
        <source>is not a choice: &apos;%1&apos;</source>
        <translation>steht nicht zur Wahl: „%1“</translation>
    </message>
    <message>
        <source>is not a finite number</source>
        <translation>ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>ist keine Zahl</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is not a single value</source>
        <translation>ist kein einzelner Wert</translation>
    </message>
    <message>
        <source>is not a table</source>
        <translation>ist keine Tabelle</translation>
    </message>
    <message>
        <source>is not a text</source>
        <translation>ist kein Text</translation>
    </message>
    <message>
        <source>is not a whole number</source>
        <translation>ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>is not an array of numbers</source>
        <translation>ist kein Feld von Zahlen</translation>
    </message>
    <message>
        <source>is not an array of rows</source>
        <translation>ist kein Feld von Zeilen</translation>
    </message>
    <message>
        <source>is not an array of tables</source>
        <translation>ist kein Feld von Tabellen</translation>
    </message>
    <message>
        <source>is not an array of texts</source>
        <translation>ist kein Feld von Texten</translation>
    </message>
    <message>
        <source>is not at %1</source>
        <translation>ist nicht bei %1</translation>
    </message>
    <message>
        <source>is not repaired: the journal beside it does not fit it</source>
        <translation>ist nicht repariert: das Journal daneben passt nicht dazu</translation>
    </message>
    <message>
        <source>is not replaced</source>
        <translation>wird nicht ersetzt</translation>
    </message>
    <message>
        <source>is out of range: %1</source>
        <translation>liegt außerhalb des Bereichs: %1</translation>
    </message>
    <message>
        <source>is spindle 0 configured?</source>
        <translation>ist Spindel 0 konfiguriert?</translation>
    </message>
    <message>
        <source>is still being recorded</source>
        <translation>wird noch aufgezeichnet</translation>
    </message>
    <message>
        <source>is stillcut-hal loaded by the machine&apos;s HAL file, and LinuxCNC started by this user?</source>
        <translation>lädt die HAL-Datei der Maschine stillcut-hal, und hat dieser Benutzer LinuxCNC gestartet?</translation>
    </message>
    <message>
        <source>is stillcut.hal wired as it came?</source>
        <translation>ist stillcut.hal verdrahtet wie geliefert?</translation>
    </message>
    <message>
        <source>is stored in pieces of more than 64 MB</source>
        <translation>ist in Stücken über 64 MB gespeichert</translation>
    </message>
    <message>
        <source>is the machine on, and the address right?</source>
        <translation>ist die Maschine an, und stimmt die Adresse?</translation>
    </message>
    <message>
        <source>is this a recording?</source>
        <translation>ist das eine Aufzeichnung?</translation>
    </message>
    <message>
        <source>is this the controller&apos;s port, and the baud rate right?</source>
        <translation>ist das der Anschluss der Steuerung, und stimmt die Baudrate?</translation>
    </message>
    <message>
        <source>is true without [write.heartbeat]</source>
        <translation>ist true ohne [write.heartbeat]</translation>
    </message>
    <message>
        <source>is unknown: &apos;%1&apos;</source>
        <translation>ist unbekannt: „%1“</translation>
    </message>
    <message>
        <source>is zero</source>
        <translation>ist null</translation>
    </message>
    <message>
        <source>it begins before the previous one ends</source>
        <translation>er beginnt, bevor der vorige endet</translation>
    </message>
    <message>
        <source>it ends before it begins</source>
        <translation>er endet, bevor er beginnt</translation>
    </message>
    <message>
        <source>it goes through stillcut-hal</source>
        <translation>er geht über stillcut-hal</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>es hat %1</translation>
    </message>
    <message>
        <source>it has %1, counted from 0</source>
        <translation>es hat %1, ab 0 gezählt</translation>
    </message>
    <message>
        <source>it has 0 to %1</source>
        <translation>es hat 0 bis %1</translation>
    </message>
    <message>
        <source>it has changed since it was opened</source>
        <translation>sie wurde seit dem Öffnen geändert</translation>
    </message>
    <message>
        <source>it has no markers</source>
        <translation>sie hat keine Marken</translation>
    </message>
    <message>
        <source>it has, from 0: %1</source>
        <translation>es hat, ab 0: %1</translation>
    </message>
    <message>
        <source>it is a recorded session; take another name</source>
        <translation>es ist eine aufgezeichnete Sitzung; anderen Namen nehmen</translation>
    </message>
    <message>
        <source>it may be a recording that is damaged; take another name</source>
        <translation>es ist vielleicht eine beschädigte Aufzeichnung; anderen Namen nehmen</translation>
    </message>
    <message>
        <source>it must be below %1</source>
        <translation>es muss unter %1 liegen</translation>
    </message>
    <message>
        <source>it names the file with outputs and calibration tables</source>
        <translation>es nennt die Datei mit Ausgängen und Kalibriertabellen</translation>
    </message>
    <message>
        <source>it names the file with the machine&apos;s registers</source>
        <translation>es nennt die Datei mit den Registern der Maschine</translation>
    </message>
    <message>
        <source>it reads up to version %1</source>
        <translation>es liest bis Version %1</translation>
    </message>
    <message>
        <source>it samples at %1</source>
        <translation>es tastet mit %1 ab</translation>
    </message>
    <message>
        <source>it says teeth and speed</source>
        <translation>es nennt Zähne und Drehzahl</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>sie wurde angehalten</translation>
    </message>
    <message>
        <source>it would run out between two commands</source>
        <translation>sie liefe zwischen zwei Befehlen ab</translation>
    </message>
    <message>
        <source>its 58b line is incomplete</source>
        <translation>seine 58b-Zeile ist unvollständig</translation>
    </message>
    <message>
        <source>its abscissa start and step are missing</source>
        <translation>Anfang und Schritt seiner Abszisse fehlen</translation>
    </message>
    <message>
        <source>its abscissa step is not positive</source>
        <translation>der Schritt seiner Abszisse ist nicht positiv</translation>
    </message>
    <message>
        <source>its byte count is not a size</source>
        <translation>seine Bytezahl ist keine Größe</translation>
    </message>
    <message>
        <source>its byte order is neither 1 (little) nor 2 (big endian)</source>
        <translation>seine Bytefolge ist weder 1 (little) noch 2 (big endian)</translation>
    </message>
    <message>
        <source>its ends must be finite</source>
        <translation>seine Enden müssen endlich sein</translation>
    </message>
    <message>
        <source>its header ends early</source>
        <translation>sein Kopf endet zu früh</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>sein Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>its header is missing</source>
        <translation>sein Kopf fehlt</translation>
    </message>
    <message>
        <source>its header is not 11 lines long</source>
        <translation>sein Kopf ist nicht 11 Zeilen lang</translation>
    </message>
    <message>
        <source>its header is wrong</source>
        <translation>sein Kopf ist falsch</translation>
    </message>
    <message>
        <source>its layout is damaged</source>
        <translation>sein Aufbau ist beschädigt</translation>
    </message>
    <message>
        <source>its level must be above zero</source>
        <translation>sein Pegel muss über null liegen</translation>
    </message>
    <message>
        <source>its name, as stillcut-cli devices lists it</source>
        <translation>sein Name, wie stillcut-cli devices ihn nennt</translation>
    </message>
    <message>
        <source>its number of points is not a size</source>
        <translation>seine Punktzahl ist keine Größe</translation>
    </message>
    <message>
        <source>its numbers are not IEEE 754</source>
        <translation>seine Zahlen sind nicht IEEE 754</translation>
    </message>
    <message>
        <source>its numbers make no sense in the byte order its header gives</source>
        <translation>seine Zahlen ergeben in der Bytefolge des Kopfs keinen Sinn</translation>
    </message>
    <message>
        <source>its ordinate type is none of 2, 4, 5, 6</source>
        <translation>sein Ordinatentyp ist keiner von 2, 4, 5, 6</translation>
    </message>
    <message>
        <source>its phase is off by 90 degrees or more, or the sensor measures nothing of the actuator there</source>
        <translation>seine Phase liegt 90 Grad oder mehr daneben, oder der Sensor hört den Aktor dort nicht</translation>
    </message>
    <message>
        <source>its samples are not evenly spaced in time</source>
        <translation>seine Werte haben keine gleichen Zeitabstände</translation>
    </message>
    <message>
        <source>its samples lie in another file</source>
        <translation>seine Werte liegen in einer anderen Datei</translation>
    </message>
    <message>
        <source>its samples lie in other data sets</source>
        <translation>seine Werte liegen in anderen Datensätzen</translation>
    </message>
    <message>
        <source>its size line (record 7) is unreadable</source>
        <translation>seine Größenzeile (Satz 7) ist unlesbar</translation>
    </message>
    <message>
        <source>its times cannot be read</source>
        <translation>seine Zeiten lassen sich nicht lesen</translation>
    </message>
    <message>
        <source>knock along %1, hard, with the machine quiet</source>
        <translation>kräftig entlang %1 klopfen, bei stiller Maschine</translation>
    </message>
    <message>
        <source>knock straight along %1, close to the sensor</source>
        <translation>gerade entlang %1 klopfen, nahe am Sensor</translation>
    </message>
    <message>
        <source>known: %1</source>
        <translation>bekannt: %1</translation>
    </message>
    <message>
        <source>label, author or note is too long</source>
        <translation>Name, Urheber oder Notiz ist zu lang</translation>
    </message>
    <message>
        <source>largest depth</source>
        <translation>größte Schnitttiefe</translation>
    </message>
    <message>
        <source>leave it out for the usual value</source>
        <translation>für den üblichen Wert weglassen</translation>
    </message>
    <message>
        <source>leaves no room for two words</source>
        <translation>lässt keinen Platz für zwei Worte</translation>
    </message>
    <message>
        <source>leaves what a machine can do</source>
        <translation>verlässt, was eine Maschine kann</translation>
    </message>
    <message>
        <source>linearise the force at the mean chip thickness first</source>
        <translation>die Kraft zuerst bei der mittleren Spandicke linearisieren</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>link &apos;simulated&apos;</source>
        <translation>Verbindung „simulated“</translation>
    </message>
    <message>
        <source>little and big endian mixed up</source>
        <translation>little und big endian verwechselt</translation>
    </message>
    <message>
        <source>mV per g, Pa, N ... of the data sheet</source>
        <translation>mV je g, Pa, N ... aus dem Datenblatt</translation>
    </message>
    <message>
        <source>more than a million speeds</source>
        <translation>mehr als eine Million Drehzahlen</translation>
    </message>
    <message>
        <source>move %1 away</source>
        <translation>%1 anderswohin verschieben</translation>
    </message>
    <message>
        <source>move %1 away to clear the mark of the dead writer alone</source>
        <translation>%1 verschieben, um nur die Marke des toten Schreibers zu löschen</translation>
    </message>
    <message>
        <source>must be a number from %1 to %2</source>
        <translation>muss eine Zahl von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>must be a number other than zero</source>
        <translation>muss eine Zahl ungleich null sein</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>must be above zero</source>
        <translation>muss über null liegen</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>must take half a second to a minute</source>
        <translation>muss eine halbe Sekunde bis eine Minute dauern</translation>
    </message>
    <message>
        <source>name one of them or their folder: %1</source>
        <translation>eines davon oder ihren Ordner nennen: %1</translation>
    </message>
    <message>
        <source>name the one to read: FILE:/path</source>
        <translation>das zu lesende nennen: DATEI:/Pfad</translation>
    </message>
    <message>
        <source>names %1 columns where the rows have %2</source>
        <translation>nennt %1 Spalten, wo die Zeilen %2 haben</translation>
    </message>
    <message>
        <source>names parted by commas were expected</source>
        <translation>durch Komma getrennte Namen wurden erwartet</translation>
    </message>
    <message>
        <source>needs one angle per tooth</source>
        <translation>braucht einen Winkel je Zahn</translation>
    </message>
    <message>
        <source>needs the numbers t_s and ratio_chatter_to_forced</source>
        <translation>braucht die Zahlen t_s und ratio_chatter_to_forced</translation>
    </message>
    <message>
        <source>neither &apos;host&apos; nor &apos;device&apos; is given</source>
        <translation>weder „host“ noch „device“ ist angegeben</translation>
    </message>
    <message>
        <source>no GRBL status report</source>
        <translation>kein GRBL-Statusbericht</translation>
    </message>
    <message>
        <source>no accelerometer along %1</source>
        <translation>kein Beschleunigungssensor entlang %1</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>no column is a channel</source>
        <translation>keine Spalte ist ein Kanal</translation>
    </message>
    <message>
        <source>no connection</source>
        <translation>keine Verbindung</translation>
    </message>
    <message>
        <source>no dataset 58 in it</source>
        <translation>kein Datensatz 58 darin</translation>
    </message>
    <message>
        <source>no force sensor along %1</source>
        <translation>kein Kraftsensor entlang %1</translation>
    </message>
    <message>
        <source>no model of the path from actuator to sensor</source>
        <translation>kein Modell des Pfads vom Aktor zum Sensor</translation>
    </message>
    <message>
        <source>no rows of numbers found in its first %1 lines</source>
        <translation>keine Zahlenreihen in den ersten %1 Zeilen</translation>
    </message>
    <message>
        <source>no spindle speed is given</source>
        <translation>keine Drehzahl angegeben</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>keine solche Datei</translation>
    </message>
    <message>
        <source>noise, or a sensor that is not on the table</source>
        <translation>Rauschen, oder ein Sensor, der nicht auf dem Tisch sitzt</translation>
    </message>
    <message>
        <source>none of its samples is a number</source>
        <translation>keiner seiner Werte ist eine Zahl</translation>
    </message>
    <message>
        <source>none was measured</source>
        <translation>keiner war zu hören</translation>
    </message>
    <message>
        <source>not a Stillcut session either</source>
        <translation>auch keine Stillcut-Sitzung</translation>
    </message>
    <message>
        <source>not a readable file</source>
        <translation>keine lesbare Datei</translation>
    </message>
    <message>
        <source>not a universal file of measured functions</source>
        <translation>keine Universaldatei mit Messfunktionen</translation>
    </message>
    <message>
        <source>there is no signal</source>
        <translation>nichts ist zu hören</translation>
    </message>
    <message>
        <source>nothing was recorded</source>
        <translation>nichts wurde aufgezeichnet</translation>
    </message>
    <message>
        <source>nothing was written to the actuator</source>
        <translation>nichts ging an den Aktor</translation>
    </message>
    <message>
        <source>one input from 0 for each of the %1 [[channels]], for example 0,1</source>
        <translation>ein Eingang ab 0 für jeden der %1 [[channels]], zum Beispiel 0,1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>one of them is needed</source>
        <translation>eines davon ist nötig</translation>
    </message>
    <message>
        <source>one of them says it all</source>
        <translation>eines davon sagt alles</translation>
    </message>
    <message>
        <source>one of them says where the machine is</source>
        <translation>eines davon sagt, wo die Maschine ist</translation>
    </message>
    <message>
        <source>one row of numbers is no recording</source>
        <translation>eine Zahlenzeile ist keine Aufzeichnung</translation>
    </message>
    <message>
        <source>only %1 % of the signal is a tone near %2 Hz</source>
        <translation>nur %1 % des Gehörten ist ein Ton bei %2 Hz</translation>
    </message>
    <message>
        <source>only Stillcut sessions say how they were made</source>
        <translation>nur Stillcut-Sitzungen sagen, wie sie entstanden</translation>
    </message>
    <message>
        <source>only sessions have markers</source>
        <translation>nur Sitzungen haben Marken</translation>
    </message>
    <message>
        <source>open it first</source>
        <translation>erst öffnen</translation>
    </message>
    <message>
        <source>output and reading differ in length</source>
        <translation>Ausgabe und Messung sind verschieden lang</translation>
    </message>
    <message>
        <source>peaks reach three times it</source>
        <translation>Spitzen erreichen das Dreifache</translation>
    </message>
    <message>
        <source>pitch angles must be above zero</source>
        <translation>Teilungswinkel müssen über null liegen</translation>
    </message>
    <message>
        <source>pitch angles must sum to 360 degrees</source>
        <translation>Teilungswinkel müssen zusammen 360 Grad ergeben</translation>
    </message>
    <message>
        <source>pitch needs one angle per tooth</source>
        <translation>die Teilung braucht einen Winkel je Zahn</translation>
    </message>
    <message>
        <source>place needs one weight per mode</source>
        <translation>place braucht ein Gewicht je Mode</translation>
    </message>
    <message>
        <source>plughw: in front of it converts them</source>
        <translation>plughw: davor wandelt sie um</translation>
    </message>
    <message>
        <source>point %1 is not a finite number</source>
        <translation>Punkt %1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>point %1 is not finite</source>
        <translation>Punkt %1 ist nicht endlich</translation>
    </message>
    <message>
        <source>profile version %1 is newer than this program</source>
        <translation>Profilversion %1 ist neuer als dieses Programm</translation>
    </message>
    <message>
        <source>promises more samples than the file holds</source>
        <translation>verspricht mehr Werte, als die Datei enthält</translation>
    </message>
    <message>
        <source>put names that hold the delimiter in quotes</source>
        <translation>Namen, die das Trennzeichen enthalten, in Anführungszeichen setzen</translation>
    </message>
    <message>
        <source>quantity or scale is missing or senseless</source>
        <translation>Messgröße oder Faktor fehlt oder ist sinnlos</translation>
    </message>
    <message>
        <source>radial immersion must lie in (0, 1]</source>
        <translation>die radiale Eingriffsbreite muss in (0, 1] liegen</translation>
    </message>
    <message>
        <source>ramps must be above zero and at most ten seconds</source>
        <translation>Rampen müssen über null und höchstens zehn Sekunden lang sein</translation>
    </message>
    <message>
        <source>random force must lie between 0 and 1000 N/sqrt(Hz)</source>
        <translation>die Zufallskraft muss zwischen 0 und 1000 N/sqrt(Hz) liegen</translation>
    </message>
    <message>
        <source>rate must lie between 10 Hz and 1 MHz</source>
        <translation>die Rate muss zwischen 10 Hz und 1 MHz liegen</translation>
    </message>
    <message>
        <source>recording failed while %1</source>
        <translation>Aufzeichnung misslungen beim Schritt: %1</translation>
    </message>
    <message>
        <source>recording stopped: the disk is nearly full</source>
        <translation>Aufzeichnung angehalten: Datenträger fast voll; Platz schaffen und neu starten</translation>
    </message>
    <message>
        <source>recording stopped: the file was deleted or moved away</source>
        <translation>Aufzeichnung angehalten: die Datei wurde gelöscht oder verschoben</translation>
    </message>
    <message>
        <source>remove the list where it belongs to another file</source>
        <translation>die Liste entfernen, wenn sie zu einer anderen Datei gehört</translation>
    </message>
    <message>
        <source>rms in %1</source>
        <translation>Effektivwert in %1</translation>
    </message>
    <message>
        <source>runout must be finite</source>
        <translation>der Rundlauf muss endlich sein</translation>
    </message>
    <message>
        <source>runout needs one value per tooth</source>
        <translation>der Rundlauf braucht einen Wert je Zahn</translation>
    </message>
    <message>
        <source>samples a second, from 100 to 1000000</source>
        <translation>Werte je Sekunde, von 100 bis 1000000</translation>
    </message>
    <message>
        <source>samples a second, one of the device&apos;s</source>
        <translation>Werte je Sekunde, eine Rate des Geräts</translation>
    </message>
    <message>
        <source>save each segment as a file of its own</source>
        <translation>jeden Abschnitt als eigene Datei sichern</translation>
    </message>
    <message>
        <source>say which one it should lie along</source>
        <translation>angeben, entlang welcher sie liegen soll</translation>
    </message>
    <message>
        <source>see gate.highest-feed</source>
        <translation>siehe gate.highest-feed</translation>
    </message>
    <message>
        <source>see gate.highest-speed, gate.tool-highest-speed, gate.holder-highest-speed and gate.highest-cutting-speed</source>
        <translation>siehe gate.highest-speed, gate.tool-highest-speed, gate.holder-highest-speed und gate.highest-cutting-speed</translation>
    </message>
    <message>
        <source>semi-discretization needs 1 to 2000 cells a tooth period</source>
        <translation>die Semidiskretisierung braucht 1 bis 2000 Zellen je Zahnperiode</translation>
    </message>
    <message>
        <source>serial ports are not part of this build</source>
        <translation>serielle Anschlüsse gehören nicht zu diesem Programmbau</translation>
    </message>
    <message>
        <source>set [device] subdevice</source>
        <translation>[device] subdevice angeben</translation>
    </message>
    <message>
        <source>set its gain lower</source>
        <translation>seine Verstärkung kleiner stellen</translation>
    </message>
    <message>
        <source>set-up</source>
        <translation>Einrichtung</translation>
    </message>
    <message>
        <source>simulated machine</source>
        <translation>simulierte Maschine</translation>
    </message>
    <message>
        <source>simulated source</source>
        <translation>simulierte Quelle</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>source &apos;simulated&apos;</source>
        <translation>Quelle „simulated“</translation>
    </message>
    <message>
        <source>speed must lie between 1 and 200000 rpm</source>
        <translation>die Drehzahl muss zwischen 1 und 200000 1/min liegen</translation>
    </message>
    <message>
        <source>speeds must be FROM:TO:STEP with 0 &lt; FROM &lt;= TO</source>
        <translation>Drehzahlen als VON:BIS:SCHRITT mit 0 &lt; VON &lt;= BIS</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>stability lobes need a force exponent of 1</source>
        <translation>Stabilitätskarten brauchen den Kraftexponenten 1</translation>
    </message>
    <message>
        <source>steps must be 8 to 5000</source>
        <translation>steps muss 8 bis 5000 sein</translation>
    </message>
    <message>
        <source>steps per revolution must lie between 0 (automatic) and 1000000</source>
        <translation>Schritte je Umdrehung müssen zwischen 0 (automatisch) und 1000000 liegen</translation>
    </message>
    <message>
        <source>stiffness must be above zero</source>
        <translation>die Steifigkeit muss über null liegen</translation>
    </message>
    <message>
        <source>stop it first</source>
        <translation>erst anhalten</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>strategy &apos;active&apos; needs a table [work_holder]</source>
        <translation>Strategie „active“ braucht eine Tabelle [work_holder]</translation>
    </message>
    <message>
        <source>subdevice %1 is no analog output</source>
        <translation>Untergerät %1 ist kein analoger Ausgang</translation>
    </message>
    <message>
        <source>such a machine tells nothing of its program</source>
        <translation>eine solche Maschine sagt nichts über ihr Programm</translation>
    </message>
    <message>
        <source>such devices are not part of this build</source>
        <translation>solche Geräte gehören nicht zu diesem Programmbau</translation>
    </message>
    <message>
        <source>switch &apos;active.auxiliary&apos; off, or take shorter blocks</source>
        <translation>„active.auxiliary“ ausschalten oder kürzere Blöcke nehmen</translation>
    </message>
    <message>
        <source>t0_s and t1_s must be times, one after the other</source>
        <translation>t0_s und t1_s müssen Zeiten sein, eine nach der anderen</translation>
    </message>
    <message>
        <source>take a larger step</source>
        <translation>größeren Schritt nehmen</translation>
    </message>
    <message>
        <source>task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>the HDF5 file cannot be opened</source>
        <translation>die HDF5-Datei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the [[channels]] are %1 in all, and %2 of them are taken</source>
        <translation>es sind insgesamt %1 [[channels]], und %2 davon sind vergeben</translation>
    </message>
    <message>
        <source>the active table needs one per axis</source>
        <translation>der aktive Tisch braucht einen je Achse</translation>
    </message>
    <message>
        <source>the amplitude limit must be above zero</source>
        <translation>die Amplitudengrenze muss über null liegen</translation>
    </message>
    <message>
        <source>the block does not fit where it is read to</source>
        <translation>der Block passt nicht an seinen Platz</translation>
    </message>
    <message>
        <source>the calibrator&apos;s level</source>
        <translation>der Pegel des Kalibrators</translation>
    </message>
    <message>
        <source>the chosen channel has no axis</source>
        <translation>der gewählte Kanal hat keine Achse</translation>
    </message>
    <message>
        <source>the data chunk is missing: a truncated file</source>
        <translation>der Datenblock fehlt: eine abgeschnittene Datei</translation>
    </message>
    <message>
        <source>the delays must rise from 0 or more to at most 10 s</source>
        <translation>die Verzögerungen müssen von 0 oder mehr bis höchstens 10 s steigen</translation>
    </message>
    <message>
        <source>the device does not run</source>
        <translation>das Gerät läuft nicht</translation>
    </message>
    <message>
        <source>the devices have %1: N_channels says how many are theirs</source>
        <translation>die Geräte haben %1: N_channels sagt, wie viele ihnen gehören</translation>
    </message>
    <message>
        <source>the fastest mode swings %1 times between two teeth</source>
        <translation>die schnellste Mode schwingt %1-mal zwischen zwei Zähnen</translation>
    </message>
    <message>
        <source>the feed range must rise from 0 or more to at most 300 %</source>
        <translation>der Vorschubbereich muss von 0 oder mehr bis höchstens 300 % steigen</translation>
    </message>
    <message>
        <source>the file is cut off</source>
        <translation>die Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>the file is cut off or its header is wrong</source>
        <translation>die Datei ist abgeschnitten oder ihr Kopf ist falsch</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>the folder cannot be written to</source>
        <translation>in den Ordner lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the gear&apos;s table must hold [cut] speed_rpm, or there is nothing to go back to</source>
        <translation>die Tabelle der Getriebestufe muss [cut] speed_rpm enthalten, sonst gibt es nichts, wohin zurück</translation>
    </message>
    <message>
        <source>the header is not &apos;t,rpm&apos;</source>
        <translation>der Kopf ist nicht „t,rpm“</translation>
    </message>
    <message>
        <source>the host cannot be found</source>
        <translation>der Rechner ist nicht zu finden</translation>
    </message>
    <message>
        <source>the leak must lie between 0.9 and 1</source>
        <translation>das Leck muss zwischen 0,9 und 1 liegen</translation>
    </message>
    <message>
        <source>the lease is shorter than two blocks</source>
        <translation>die Befugnis ist kürzer als zwei Blöcke</translation>
    </message>
    <message>
        <source>the lease must be above zero and at most one second</source>
        <translation>die Befugnis muss über null und höchstens eine Sekunde lang sein</translation>
    </message>
    <message>
        <source>the level moves by %1 %</source>
        <translation>der Pegel schwankt um %1 %</translation>
    </message>
    <message>
        <source>the line is too long</source>
        <translation>die Zeile ist zu lang</translation>
    </message>
    <message>
        <source>the longest was %1 of %2</source>
        <translation>das längste war %1 von %2</translation>
    </message>
    <message>
        <source>the lowest feed is not below the highest</source>
        <translation>der kleinste Vorschub liegt nicht unter dem größten</translation>
    </message>
    <message>
        <source>the lowest speed is not below the highest</source>
        <translation>die kleinste Drehzahl liegt nicht unter der größten</translation>
    </message>
    <message>
        <source>the machine&apos;s override cannot reach the allowed range</source>
        <translation>der Override der Maschine erreicht den erlaubten Bereich nicht</translation>
    </message>
    <message>
        <source>the machine&apos;s state is incomplete</source>
        <translation>der Zustand der Maschine ist unvollständig</translation>
    </message>
    <message>
        <source>the machine&apos;s watchdog was not seen to act</source>
        <translation>der Wächter der Maschine hat sich nicht gerührt</translation>
    </message>
    <message>
        <source>the marker cannot be written</source>
        <translation>die Marke lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the markers cannot be read</source>
        <translation>die Marken lassen sich nicht lesen</translation>
    </message>
    <message>
        <source>the model along %1 is %2 minutes old</source>
        <translation>das Modell entlang %1 ist %2 Minuten alt</translation>
    </message>
    <message>
        <source>the model along %1 has no phase margin on the lines to quieten, worst at %2 Hz</source>
        <translation>das Modell entlang %1 verspricht auf den zu dämpfenden Linien keine Stabilität, am schlechtesten bei %2 Hz</translation>
    </message>
    <message>
        <source>the nearest is %1</source>
        <translation>am nächsten liegt %1</translation>
    </message>
    <message>
        <source>the number of channels changed</source>
        <translation>die Kanalzahl hat sich geändert</translation>
    </message>
    <message>
        <source>the order of semi-discretization must be 0 or 1</source>
        <translation>die Ordnung der Semidiskretisierung muss 0 oder 1 sein</translation>
    </message>
    <message>
        <source>the output does not take the programmed values</source>
        <translation>der Ausgang nimmt die programmierten Werte nicht an</translation>
    </message>
    <message>
        <source>the pace must be above zero</source>
        <translation>das Tempo muss über null liegen</translation>
    </message>
    <message>
        <source>the pace must be zero (as fast as possible) or above, with a clock</source>
        <translation>das Tempo muss null (so schnell wie möglich) oder größer sein, mit einer Uhr</translation>
    </message>
    <message>
        <source>the path may be later than its model says; identify it again</source>
        <translation>der Pfad kann später sein, als sein Modell sagt; neu identifizieren</translation>
    </message>
    <message>
        <source>the path&apos;s model has more than %1 taps</source>
        <translation>das Pfadmodell hat mehr als %1 Koeffizienten</translation>
    </message>
    <message>
        <source>the path&apos;s model holds a number that is not finite</source>
        <translation>das Pfadmodell enthält eine nicht endliche Zahl</translation>
    </message>
    <message>
        <source>the path&apos;s model is delayed by more than %1 samples</source>
        <translation>das Pfadmodell ist um mehr als %1 Werte verzögert</translation>
    </message>
    <message>
        <source>the path&apos;s model is unstable</source>
        <translation>das Pfadmodell ist instabil</translation>
    </message>
    <message>
        <source>the path&apos;s model says that the actuator does nothing</source>
        <translation>laut Pfadmodell bewirkt der Aktor nichts</translation>
    </message>
    <message>
        <source>the paths are being identified</source>
        <translation>die Pfade werden identifiziert</translation>
    </message>
    <message>
        <source>the profile&apos;s has %1</source>
        <translation>das des Profils hat %1</translation>
    </message>
    <message>
        <source>the programmed speed is outside the speed table</source>
        <translation>die programmierte Drehzahl liegt außerhalb der Drehzahltabelle</translation>
    </message>
    <message>
        <source>the programmed value must be reachable</source>
        <translation>der programmierte Wert muss erreichbar sein</translation>
    </message>
    <message>
        <source>the range of the feed override is empty</source>
        <translation>der Bereich des Vorschub-Overrides ist leer</translation>
    </message>
    <message>
        <source>the range of the speed override is empty</source>
        <translation>der Bereich des Drehzahl-Overrides ist leer</translation>
    </message>
    <message>
        <source>the reading does not follow the actuator</source>
        <translation>die Messung folgt dem Aktor nicht</translation>
    </message>
    <message>
        <source>the registers do not answer</source>
        <translation>die Register antworten nicht</translation>
    </message>
    <message>
        <source>the repaired file could not be written</source>
        <translation>die reparierte Datei ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>the sample rate must be above zero</source>
        <translation>die Abtastrate muss über null liegen</translation>
    </message>
    <message>
        <source>the samples are missing</source>
        <translation>die Messwerte fehlen</translation>
    </message>
    <message>
        <source>the samples cannot be read</source>
        <translation>die Messwerte lassen sich nicht lesen</translation>
    </message>
    <message>
        <source>the sampling rate is not known: it holds neither a rate nor times</source>
        <translation>die Abtastrate ist unbekannt: weder Rate noch Zeiten enthalten</translation>
    </message>
    <message>
        <source>the sampling rate is not known: there is no time column</source>
        <translation>die Abtastrate ist unbekannt: es gibt keine Zeitspalte</translation>
    </message>
    <message>
        <source>the sampling rate is senseless</source>
        <translation>die Abtastrate ist sinnlos</translation>
    </message>
    <message>
        <source>the sensor read nothing</source>
        <translation>der Sensor las nichts</translation>
    </message>
    <message>
        <source>the session file cannot be created</source>
        <translation>die Sitzungsdatei lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>the session file cannot be opened</source>
        <translation>die Sitzungsdatei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the session file cannot be repaired</source>
        <translation>die Sitzungsdatei lässt sich nicht reparieren</translation>
    </message>
    <message>
        <source>the session file is damaged</source>
        <translation>die Sitzungsdatei ist beschädigt</translation>
    </message>
    <message>
        <source>the session file was not closed cleanly</source>
        <translation>die Sitzungsdatei wurde nicht sauber geschlossen</translation>
    </message>
    <message>
        <source>the session has others</source>
        <translation>die Sitzung hat andere</translation>
    </message>
    <message>
        <source>the session is closed</source>
        <translation>die Sitzung ist geschlossen</translation>
    </message>
    <message>
        <source>the setup is missing</source>
        <translation>die Einrichtung fehlt</translation>
    </message>
    <message>
        <source>the setup is senseless</source>
        <translation>die Einrichtung ist sinnlos</translation>
    </message>
    <message>
        <source>the size in its header is wrong, or the file is cut off</source>
        <translation>die Größe im Kopf ist falsch, oder die Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>the slew limit must be above zero</source>
        <translation>die Anstiegsgrenze muss über null liegen</translation>
    </message>
    <message>
        <source>the span from %1 is empty</source>
        <translation>der Abschnitt ab %1 ist leer</translation>
    </message>
    <message>
        <source>the span holds no samples</source>
        <translation>der Abschnitt enthält keine Messwerte</translation>
    </message>
    <message>
        <source>the speed must be above zero</source>
        <translation>die Drehzahl muss über null liegen</translation>
    </message>
    <message>
        <source>the speed range is empty</source>
        <translation>der Drehzahlbereich ist leer</translation>
    </message>
    <message>
        <source>the speed range must rise from above 0 to at most 300 %</source>
        <translation>der Drehzahlbereich muss von über 0 bis höchstens 300 % steigen</translation>
    </message>
    <message>
        <source>the step between speeds must be above zero</source>
        <translation>der Schritt zwischen Drehzahlen muss über null liegen</translation>
    </message>
    <message>
        <source>the step must lie between 0 and 1</source>
        <translation>der Schritt muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>the table of blocks cannot be read</source>
        <translation>die Blocktabelle lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>the tangential coefficient must be above zero</source>
        <translation>der tangentiale Koeffizient muss über null liegen</translation>
    </message>
    <message>
        <source>the time column does not grow</source>
        <translation>die Zeitspalte wächst nicht</translation>
    </message>
    <message>
        <source>the time does not rise</source>
        <translation>die Zeit steigt nicht</translation>
    </message>
    <message>
        <source>the time repeats</source>
        <translation>die Zeit wiederholt sich</translation>
    </message>
    <message>
        <source>the time runs backwards</source>
        <translation>die Zeit läuft rückwärts</translation>
    </message>
    <message>
        <source>the time steps are uneven</source>
        <translation>die Zeitschritte sind ungleich</translation>
    </message>
    <message>
        <source>the tone is cut off at the input&apos;s limit</source>
        <translation>der Ton ist an der Grenze des Eingangs abgeschnitten</translation>
    </message>
    <message>
        <source>the tool has %1 teeth</source>
        <translation>das Werkzeug hat %1 Zähne</translation>
    </message>
    <message>
        <source>the tool&apos;s cutting speed lies below the speed range</source>
        <translation>die Schnittgeschwindigkeit des Werkzeugs liegt unter dem Drehzahlbereich</translation>
    </message>
    <message>
        <source>the tool&apos;s cutting speed must be above zero</source>
        <translation>die Schnittgeschwindigkeit des Werkzeugs muss über null liegen</translation>
    </message>
    <message>
        <source>the value is not a finite number</source>
        <translation>der Wert ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the work-holder needs a flexure with frequency, damping and stiffness</source>
        <translation>der Werkstückhalter braucht ein Gelenk mit Frequenz, Dämpfung und Steifigkeit</translation>
    </message>
    <message>
        <source>the work-holder&apos;s filter and amplifier need a bandwidth and a slew limit</source>
        <translation>Filter und Verstärker des Werkstückhalters brauchen Bandbreite und Anstiegsgrenze</translation>
    </message>
    <message>
        <source>the work-holder&apos;s lines to quieten must be positive frequencies</source>
        <translation>die zu dämpfenden Linien des Werkstückhalters müssen positive Frequenzen sein</translation>
    </message>
    <message>
        <source>the work-holder&apos;s stroke must be above zero and at most 1 mm</source>
        <translation>der Hub des Werkstückhalters muss über null und höchstens 1 mm sein</translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>es gibt: %1</translation>
    </message>
    <message>
        <source>there is no channel %1</source>
        <translation>es gibt keinen Kanal %1</translation>
    </message>
    <message>
        <source>there is no clock here</source>
        <translation>hier gibt es keine Uhr</translation>
    </message>
    <message>
        <source>there is no plant to drive</source>
        <translation>es gibt keine Strecke zu steuern</translation>
    </message>
    <message>
        <source>there is no such array in the file</source>
        <translation>ein solches Feld gibt es in der Datei nicht</translation>
    </message>
    <message>
        <source>there is no such data set or folder in the file</source>
        <translation>einen solchen Datensatz oder Ordner gibt es in der Datei nicht</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>eine solche Datei gibt es nicht</translation>
    </message>
    <message>
        <source>there is no trigger &apos;%1&apos; at %2</source>
        <translation>es gibt keinen Trigger „%1“ an %2</translation>
    </message>
    <message>
        <source>there is no wire to a real device here</source>
        <translation>hier führt keine Leitung zu einem echten Gerät</translation>
    </message>
    <message>
        <source>there is no wire to a real machine here</source>
        <translation>hier führt keine Leitung zu einer echten Maschine</translation>
    </message>
    <message>
        <source>there is nothing to exchange it with</source>
        <translation>es gibt nichts, womit er zu tauschen wäre</translation>
    </message>
    <message>
        <source>they must rise</source>
        <translation>sie müssen steigen</translation>
    </message>
    <message>
        <source>this HDF5 library cannot repair files</source>
        <translation>diese HDF5-Bibliothek kann keine Dateien reparieren</translation>
    </message>
    <message>
        <source>this is no text recording</source>
        <translation>das ist keine Textaufzeichnung</translation>
    </message>
    <message>
        <source>this program reads versions %1 to %2</source>
        <translation>dieses Programm liest Versionen %1 bis %2</translation>
    </message>
    <message>
        <source>this program was built without alsa-lib</source>
        <translation>dieses Programm wurde ohne alsa-lib gebaut</translation>
    </message>
    <message>
        <source>this recording cannot be gone back in</source>
        <translation>in dieser Aufzeichnung geht es nicht zurück</translation>
    </message>
    <message>
        <source>too short</source>
        <translation>zu kurz</translation>
    </message>
    <message>
        <source>too short to identify a path from</source>
        <translation>zu kurz, um einen Pfad zu identifizieren</translation>
    </message>
    <message>
        <source>turns too slowly for its rate</source>
        <translation>dreht zu langsam für seine Rate</translation>
    </message>
    <message>
        <source>two devices or more are joined: 1_id, 2_id ...</source>
        <translation>zwei oder mehr Geräte werden verbunden: 1_id, 2_id ...</translation>
    </message>
    <message>
        <source>two seconds are needed</source>
        <translation>zwei Sekunden sind nötig</translation>
    </message>
    <message>
        <source>two seconds of the tone are needed</source>
        <translation>zwei Sekunden des Tons sind nötig</translation>
    </message>
    <message>
        <source>unevenness must lie between 0 and 0.01 / sqrt(Hz)</source>
        <translation>die Ungleichmäßigkeit muss zwischen 0 und 0,01 / sqrt(Hz) liegen</translation>
    </message>
    <message>
        <source>unknown id &apos;%1&apos;</source>
        <translation>unbekannte Kennung „%1“</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos;</source>
        <translation>unbekannter Schlüssel „%1“</translation>
    </message>
    <message>
        <source>up to 64 can be read</source>
        <translation>bis zu 64 lassen sich lesen</translation>
    </message>
    <message>
        <source>use the link &apos;simulated&apos;</source>
        <translation>die Verbindung „simulated“ verwenden</translation>
    </message>
    <message>
        <source>virtual data sets are not read</source>
        <translation>virtuelle Datensätze werden nicht gelesen</translation>
    </message>
    <message>
        <source>volts of one device unit, for example of full scale</source>
        <translation>Volt einer Geräteeinheit, zum Beispiel des Vollausschlags</translation>
    </message>
    <message>
        <source>wait for the end</source>
        <translation>das Ende abwarten</translation>
    </message>
    <message>
        <source>what full scale means must be a number other than 0</source>
        <translation>was Vollausschlag bedeutet, muss eine Zahl ungleich 0 sein</translation>
    </message>
    <message>
        <source>what is there is left as it is</source>
        <translation>was da ist, bleibt, wie es ist</translation>
    </message>
    <message>
        <source>what would the machine watch?</source>
        <translation>was würde die Maschine überwachen?</translation>
    </message>
    <message>
        <source>without it nothing can be told or done</source>
        <translation>ohne sie lässt sich nichts sagen oder tun</translation>
    </message>
    <message>
        <source>x and y are on the same channel</source>
        <translation>x und y liegen auf demselben Kanal</translation>
    </message>
    <message>
        <source>zeroth order averages the force (a tooth cuts %1 % of the time): expect errors of tens of percent between the lobes; the exact method has none</source>
        <translation>die nullte Ordnung mittelt die Kraft (ein Zahn schneidet %1 % der Zeit): zwischen den Lobes sind Fehler von einigen zehn Prozent zu erwarten; die exakte Methode hat keine</translation>
    </message>
    <message>
        <source>zeroth order averages the force although a tooth cuts only %1 % of the time: limits can be far too high, flip lobes and islands are missing; use the exact method</source>
        <translation>die nullte Ordnung mittelt die Kraft, obwohl ein Zahn nur %1 % der Zeit schneidet: Grenzen können viel zu hoch sein, Flip-Lobes und Inseln fehlen; die exakte Methode nehmen</translation>
    </message>
    <message>
        <source>cannot be read as TOML</source>
        <translation>kann nicht als TOML gelesen werden</translation>
    </message>
    <message>
        <source>%1 is above %2 of %3</source>
        <translation>%1 ist mehr als %2 von %3</translation>
    </message>
    <message>
        <source>must be above fuzzy.energy-reference</source>
        <translation>muss über fuzzy.energy-reference liegen</translation>
    </message>
    <message>
        <source>rules must fall as coherence rises</source>
        <translation>Regeln müssen fallen, wenn die Kohärenz steigt</translation>
    </message>
    <message>
        <source>A machine state older than this is stale; auto: three of the link&apos;s own periods and a block</source>
        <translation>Ein älterer Maschinenzustand ist veraltet; auto: drei Perioden der Verbindung selbst und ein Block</translation>
    </message>
    <message>
        <source>every machine state would be stale</source>
        <translation>jeder Maschinenzustand wäre veraltet</translation>
    </message>
    <message>
        <source>no override could be seen in force in time</source>
        <translation>kein Override wäre rechtzeitig als wirksam zu sehen</translation>
    </message>
    <message>
        <source>the link reads the machine every %1 ms: at least two of its periods</source>
        <translation>die Verbindung liest die Maschine alle %1 ms: mindestens zwei ihrer Perioden</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>wie gesetzt</translation>
    </message>
    <message>
        <source>a quarter of the told spindle frequency</source>
        <translation>ein Viertel der genannten Spindelfrequenz</translation>
    </message>
    <message>
        <source>low enough for any spindle, as no speed was told</source>
        <translation>tief genug für jede Spindel, da keine Drehzahl genannt ist</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>nobody has told it, and the signal has not shown it</source>
        <translation>niemand hat sie genannt, und das Signal hat sie nicht gezeigt</translation>
    </message>
    <message>
        <source>as told</source>
        <translation>wie genannt</translation>
    </message>
    <message>
        <source>as the machine reads it</source>
        <translation>wie die Maschine sie misst</translation>
    </message>
    <message>
        <source>found in the signal, and followed</source>
        <translation>im Signal gefunden und verfolgt</translation>
    </message>
    <message>
        <source>no speed is known</source>
        <translation>keine Drehzahl bekannt</translation>
    </message>
    <message>
        <source>of what was told</source>
        <translation>dessen, was genannt ist</translation>
    </message>
    <message>
        <source>of what the signal shows</source>
        <translation>dessen, was das Signal zeigt</translation>
    </message>
    <message>
        <source>Noise in air, channel 1</source>
        <translation>Rauschen in Luft, Kanal 1</translation>
    </message>
    <message>
        <source>no air has been heard yet</source>
        <translation>noch keine Luft gehört</translation>
    </message>
    <message>
        <source>the quietest fifth of a second so far</source>
        <translation>die leiseste Fünftelsekunde bisher</translation>
    </message>
    <message>
        <source>Noise in air, channel 2</source>
        <translation>Rauschen in Luft, Kanal 2</translation>
    </message>
    <message>
        <source>Noise in air, channel 3</source>
        <translation>Rauschen in Luft, Kanal 3</translation>
    </message>
    <message>
        <source>Noise in air, channel 4</source>
        <translation>Rauschen in Luft, Kanal 4</translation>
    </message>
    <message>
        <source>as many as the working rate hears at this speed</source>
        <translation>so viele, wie die Arbeitsrate bei dieser Drehzahl hört</translation>
    </message>
    <message>
        <source>32, where the forced vibration of most cuts ends</source>
        <translation>32: so weit reicht die erzwungene Schwingung der meisten Schnitte</translation>
    </message>
    <message>
        <source>a memory of two turns at this speed</source>
        <translation>Gedächtnis von zwei Umdrehungen bei dieser Drehzahl</translation>
    </message>
    <message>
        <source>leaves 1 % of each harmonic</source>
        <translation>lässt 1 % jeder Harmonischen übrig</translation>
    </message>
    <message>
        <source>thinned by a whole factor to the paper&apos;s 10 kHz or somewhat more</source>
        <translation>um einen ganzen Faktor ausgedünnt, auf die 10 kHz der Arbeit oder etwas mehr</translation>
    </message>
    <message>
        <source>the sampling rate itself</source>
        <translation>die Abtastrate selbst</translation>
    </message>
    <message>
        <source>not yet: it is learned in the steady cut</source>
        <translation>noch nicht: wird im gleichmäßigen Schnitt gelernt</translation>
    </message>
    <message>
        <source>four times the noise floor, or the least growth that counts</source>
        <translation>das Vierfache des Rauschpegels oder das kleinste Wachstum, das zählt</translation>
    </message>
    <message>
        <source>Scale of the signal</source>
        <translation>Maßstab des Signals</translation>
    </message>
    <message>
        <source>mean of the stable cut so far</source>
        <translation>Mittel des bisherigen stabilen Schnitts</translation>
    </message>
    <message>
        <source>held while an alarm lasts</source>
        <translation>gehalten, solange ein Alarm dauert</translation>
    </message>
    <message>
        <source>Noise floor</source>
        <translation>Rauschpegel</translation>
    </message>
    <message>
        <source>28 turns at the told speed</source>
        <translation>28 Umdrehungen bei der genannten Drehzahl</translation>
    </message>
    <message>
        <source>1.5 s, the most, which 28 turns would exceed</source>
        <translation>1.5 s, die größte Länge; 28 Umdrehungen wären länger</translation>
    </message>
    <message>
        <source>the paper&apos;s, as no speed was told</source>
        <translation>die der Arbeit, da keine Drehzahl genannt ist</translation>
    </message>
    <message>
        <source>as many as the sampling rate hears at this speed</source>
        <translation>so viele, wie die Abtastrate bei dieser Drehzahl hört</translation>
    </message>
    <message>
        <source>the least there are, for a tool of few teeth</source>
        <translation>die kleinste Zahl, für ein Werkzeug mit wenigen Zähnen</translation>
    </message>
    <message>
        <source>12 tooth passings</source>
        <translation>12 Zahneingriffe</translation>
    </message>
    <message>
        <source>Growth that is an onset</source>
        <translation>Wachstum, das als Beginn gilt</translation>
    </message>
    <message>
        <source>four times the noise floor in energy</source>
        <translation>das Vierfache des Rauschpegels, in Energie</translation>
    </message>
    <message>
        <source>the smallest onset, as set, which the noise does not reach</source>
        <translation>der kleinste Beginn, wie gesetzt; das Rauschen reicht nicht so weit</translation>
    </message>
    <message>
        <source>12 turns at the told speed</source>
        <translation>12 Umdrehungen bei der genannten Drehzahl</translation>
    </message>
    <message>
        <source>the paper&apos;s, which 12 turns would exceed</source>
        <translation>die der Arbeit; 12 Umdrehungen wären länger</translation>
    </message>
    <message>
        <source>12 turns of a slow spindle, as no speed was told</source>
        <translation>12 Umdrehungen einer langsamen Spindel, da keine Drehzahl genannt ist</translation>
    </message>
    <message>
        <source>of what changes from turn to turn: four times the noise floor, or the least that counts</source>
        <translation>für das, was sich von Umdrehung zu Umdrehung ändert: das Vierfache des Rauschpegels oder das Kleinste, das zählt</translation>
    </message>
    <message>
        <source>Usual coherence</source>
        <translation>Übliche Kohärenz</translation>
    </message>
    <message>
        <source>noise, full scale, step, counts and bandwidth must not be negative</source>
        <translation>Rauschen, Vollausschlag, Stufe, Impulse und Bandbreite dürfen nicht negativ sein</translation>
    </message>
    <message>
        <source>the torque loop&apos;s bandwidth must not be negative</source>
        <translation>die Bandbreite des Drehmomentreglers darf nicht negativ sein</translation>
    </message>
    <message>
        <source>Energy ratio (eq. 28) from which a cut is in full chatter; more where it is high in the calm cut</source>
        <translation>Energieanteil (Gl. 28), ab dem ein Schnitt voll rattert; mehr, wo er im ruhigen Schnitt hoch ist</translation>
    </message>
    <message>
        <source>Full chatter</source>
        <translation>Volles Rattern</translation>
    </message>
    <message>
        <source>the chatter ratio, as set</source>
        <translation>der Ratteranteil, wie gesetzt</translation>
    </message>
    <message>
        <source>four times what the channel has in the calm cut</source>
        <translation>das Vierfache dessen, was der Kanal im ruhigen Schnitt hat</translation>
    </message>
    <message>
        <source>&apos;%1&apos; converts, or stands before what does, which may change the rate and mix channels; hw: names the device itself</source>
        <translation>„%1“ wandelt um oder steht vor etwas, das umwandelt; das kann die Abtastrate ändern und Kanäle mischen; hw: nennt das Gerät selbst</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a sound server&apos;s, which may change the rate and mix channels; hw: names the device itself</source>
        <translation>„%1“ gehört einem Soundserver, der die Abtastrate ändern und Kanäle mischen kann; hw: nennt das Gerät selbst</translation>
    </message>
    <message>
        <source>0 to 400 %</source>
        <translation>0 bis 400 %</translation>
    </message>
    <message>
        <source>HDF5: %1</source>
        <translation>HDF5: %1</translation>
    </message>
    <message>
        <source>[[volts, value], [volts, value], ...]</source>
        <translation>[[Volt, Wert], [Volt, Wert], ...]</translation>
    </message>
    <message>
        <source>[volts, value]</source>
        <translation>[Volt, Wert]</translation>
    </message>
    <message>
        <source>allowed: %1 to %2, or auto</source>
        <translation>erlaubt: %1 bis %2 oder auto</translation>
    </message>
    <message>
        <source>cannot be tried</source>
        <translation>kann nicht versucht werden</translation>
    </message>
    <message>
        <source>cannot be tried: %1 does not start</source>
        <translation>kann nicht versucht werden: %1 startet nicht</translation>
    </message>
    <message>
        <source>cannot be written here</source>
        <translation>kann hier nicht geschrieben werden</translation>
    </message>
    <message>
        <source>cannot be written: more than 268 million samples a channel</source>
        <translation>kann nicht geschrieben werden: mehr als 268 Millionen Abtastwerte je Kanal</translation>
    </message>
    <message>
        <source>cannot be written: too many samples for this format</source>
        <translation>kann nicht geschrieben werden: zu viele Abtastwerte für dieses Format</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; holds &apos;%2&apos;</source>
        <translation>Spalte „%1“ enthält „%2“</translation>
    </message>
    <message>
        <source>export a span, or to .h5</source>
        <translation>einen Ausschnitt exportieren, oder nach .h5</translation>
    </message>
    <message>
        <source>input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>is &apos;%1&apos;</source>
        <translation>ist „%1“</translation>
    </message>
    <message>
        <source>it samples at %1, and could at %2</source>
        <translation>es tastet mit %1 ab und könnte mit %2</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>rms in %1, or as &quot;1 g&quot;</source>
        <translation>Effektivwert in %1, oder als &quot;1 g&quot;</translation>
    </message>
    <message>
        <source>rms in %1, or as &quot;94 dB&quot;</source>
        <translation>Effektivwert in %1, oder als &quot;94 dB&quot;</translation>
    </message>
    <message>
        <source>stillcut --report IN OUT makes reports and pictures</source>
        <translation>stillcut --report IN OUT macht Berichte und Bilder</translation>
    </message>
    <message>
        <source>the HDF5 library cannot read it</source>
        <translation>die HDF5-Bibliothek kann es nicht lesen</translation>
    </message>
    <message>
        <source>the longest was %1 of %2: samples are lost again and again</source>
        <translation>das längste war %1 von %2: immer wieder gehen Abtastwerte verloren</translation>
    </message>
    <message>
        <source>the program stillcut-reader is missing beside this one</source>
        <translation>das Programm stillcut-reader fehlt neben diesem</translation>
    </message>
    <message>
        <source>the suffix must be one of %1</source>
        <translation>die Endung muss eine von %1 sein</translation>
    </message>
    <message>
        <source>toml++: %1</source>
        <translation>toml++: %1</translation>
    </message>
    <message>
        <source>universal file</source>
        <translation>Universaldatei</translation>
    </message>
    <message>
        <source>use .h5</source>
        <translation>.h5 verwenden</translation>
    </message>
    <message>
        <source>the log cannot be written there</source>
        <translation>das Protokoll kann dort nicht geschrieben werden</translation>
    </message>
    <message>
        <source>nests tables too deeply: no file of settings</source>
        <translation>verschachtelt Tabellen zu tief: keine Datei mit Einstellungen</translation>
    </message>
    <message>
        <source>another Stillcut holds this machine (process %1)</source>
        <translation>ein anderes Stillcut hält diese Maschine (Prozess %1)</translation>
    </message>
    <message>
        <source>end that one, or watch here without a machine link</source>
        <translation>jenes beenden, oder hier ohne Maschinenanbindung beobachten</translation>
    </message>
    <message>
        <source>its state is on the page Operate; to try the link, end the run first</source>
        <translation>ihr Zustand steht auf der Seite Bedienen; um die Anbindung zu prüfen, zuerst den Lauf beenden</translation>
    </message>
    <message>
        <source>the run that is going on holds this machine</source>
        <translation>der laufende Lauf hält diese Maschine</translation>
    </message>
    <message>
        <source>%1 was cut short by another program</source>
        <translation>%1 wurde von einem anderen Programm gekürzt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no question to a session</source>
        <translation>&apos;%1&apos; ist keine Frage an eine Sitzung</translation>
    </message>
    <message>
        <source>&apos;%1&apos; reads %2, which can not be</source>
        <translation>&apos;%1&apos; liest sich als %2, was nicht sein kann</translation>
    </message>
    <message>
        <source>a Stillcut that was killed left spindle %1 %, feed %2 %; the operator had %3 %, %4 %: BACK TO 100 % brings that back</source>
        <translation>ein abgebrochenes Stillcut hinterließ Spindel %1 %, Vorschub %2 %; der Bediener hatte %3 %, %4 %: ZURÜCK AUF 100 % stellt das wieder her</translation>
    </message>
    <message>
        <source>a float has two words and a sign of its own, and is no flag</source>
        <translation>eine Gleitkommazahl hat zwei Wörter und ein eigenes Vorzeichen und ist kein Schalter</translation>
    </message>
    <message>
        <source>is its entry in the register map right?</source>
        <translation>Stimmt sein Eintrag in der Registertabelle?</translation>
    </message>
    <message>
        <source>is no session that can be looked into</source>
        <translation>ist keine Sitzung, in die man hineinsehen kann</translation>
    </message>
    <message>
        <source>is not below &apos;highest&apos;</source>
        <translation>liegt nicht unter &apos;highest&apos;</translation>
    </message>
    <message>
        <source>is the sender running there, and connected to its machine?</source>
        <translation>Läuft dort der Sender, und ist er mit seiner Maschine verbunden?</translation>
    </message>
    <message>
        <source>is there already</source>
        <translation>ist schon da</translation>
    </message>
    <message>
        <source>is true beside &apos;words = 1&apos;, &apos;signed&apos; or &apos;bit&apos;</source>
        <translation>ist wahr neben &apos;words = 1&apos;, &apos;signed&apos; oder &apos;bit&apos;</translation>
    </message>
    <message>
        <source>no value would be believed</source>
        <translation>kein Wert würde geglaubt</translation>
    </message>
    <message>
        <source>recording stopped: the file was cut short by another program</source>
        <translation>Aufzeichnung beendet: die Datei wurde von einem anderen Programm gekürzt</translation>
    </message>
    <message>
        <source>the header promises %1 bytes of samples, the file holds %2, which are read: its recorder did not end it</source>
        <translation>der Dateikopf verspricht %1 Byte Messwerte, die Datei enthält %2, die gelesen werden: ihr Rekorder hat sie nicht abgeschlossen</translation>
    </message>
    <message>
        <source>this folder has no file locks, without which a recording is not safe (%1)</source>
        <translation>dieser Ordner kennt keine Dateisperren, ohne die eine Aufzeichnung nicht sicher ist (%1)</translation>
    </message>
    <message>
        <source>spindle programmed %1 rpm, not measured</source>
        <translation>Spindel %1 1/min programmiert, nicht gemessen</translation>
    </message>
    <message>
        <source>an order was seen to act, and to be taken back, after %1 ms</source>
        <translation>ein Befehl hat sichtbar gewirkt und wurde zurückgenommen, nach %1 ms</translation>
    </message>
    <message>
        <source>no order has shown it yet: nothing was moved</source>
        <translation>noch hat es kein Befehl gezeigt: nichts wurde bewegt</translation>
    </message>
    <message>
        <source>Sender</source>
        <translation>Sendeprogramm</translation>
    </message>
    <message>
        <source>Sender port</source>
        <translation>Port des Sendeprogramms</translation>
    </message>
    <message>
        <source>Sender name</source>
        <translation>Name am Sendeprogramm</translation>
    </message>
    <message>
        <source>Sender password</source>
        <translation>Passwort am Sendeprogramm</translation>
    </message>
    <message>
        <source>Uncertainty of the speed</source>
        <translation>Unsicherheit der Drehzahl</translation>
    </message>
    <message>
        <source>%1 of %2 rows hold no number where one belongs and are missing; the first: %3</source>
        <translation>in %1 von %2 Zeilen fehlt eine Zahl, sie gelten als Lücke; die erste: %3</translation>
    </message>
    <message>
        <source>%1; the machine before runs again, authority is Off</source>
        <translation>%1; die Maschine davor läuft wieder, Befugnis ist Aus</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no row of numbers</source>
        <translation>&apos;%1&apos; ist keine Zeile mit Zahlen</translation>
    </message>
    <message>
        <source>a section of the tool has no length or no diameter</source>
        <translation>ein Abschnitt des Werkzeugs hat keine Länge oder keinen Durchmesser</translation>
    </message>
    <message>
        <source>a spread must lie between 0 and 50 %</source>
        <translation>eine Streuung muss zwischen 0 und 50 % liegen</translation>
    </message>
    <message>
        <source>channel &apos;%1&apos; is left out: %2 beside %3</source>
        <translation>Kanal &apos;%1&apos; bleibt weg: %2 neben %3</translation>
    </message>
    <message>
        <source>close it there, or run h5clear -s on a copy of it</source>
        <translation>dort schließen oder h5clear -s auf eine Kopie anwenden</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; is left out: most of its cells hold no number</source>
        <translation>Spalte &apos;%1&apos; bleibt weg: die meisten ihrer Zellen enthalten keine Zahl</translation>
    </message>
    <message>
        <source>commas seem to be both decimal signs and delimiters</source>
        <translation>Kommas scheinen zugleich Dezimal- und Trennzeichen zu sein</translation>
    </message>
    <message>
        <source>convert it to WAV: ffmpeg -i FILE cut.wav</source>
        <translation>in WAV umwandeln: ffmpeg -i FILE cut.wav</translation>
    </message>
    <message>
        <source>export it as CSV, or write it as HDF5 in Python: %1</source>
        <translation>als CSV exportieren oder in Python als HDF5 schreiben: %1</translation>
    </message>
    <message>
        <source>export with decimal points and without signs between thousands</source>
        <translation>mit Dezimalpunkten und ohne Tausendertrennzeichen exportieren</translation>
    </message>
    <message>
        <source>export with decimal points, or with semicolons between the columns</source>
        <translation>mit Dezimalpunkten exportieren oder mit Semikolons zwischen den Spalten</translation>
    </message>
    <message>
        <source>has other lines than %1</source>
        <translation>hat andere Linien als %1</translation>
    </message>
    <message>
        <source>helix needs one angle per tooth</source>
        <translation>der Drall braucht einen Winkel je Zahn</translation>
    </message>
    <message>
        <source>holds %1 sound tracks, of which one is read</source>
        <translation>enthält %1 Tonspuren, von denen eine gelesen wird</translation>
    </message>
    <message>
        <source>holds a sample that is not a finite number</source>
        <translation>enthält einen Abtastwert, der keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>holds no array of real numbers in one or two dimensions</source>
        <translation>enthält kein Feld reeller Zahlen in einer oder zwei Dimensionen</translation>
    </message>
    <message>
        <source>holds no line above 0 Hz</source>
        <translation>enthält keine Linie über 0 Hz</translation>
    </message>
    <message>
        <source>holds no sound track</source>
        <translation>enthält keine Tonspur</translation>
    </message>
    <message>
        <source>is a ZIP archive above 4 GiB</source>
        <translation>ist ein ZIP-Archiv über 4 GiB</translation>
    </message>
    <message>
        <source>is a file of the format %1, which is not read</source>
        <translation>ist eine Datei im Format %1, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>is a phone&apos;s or a camera&apos;s file, and this Stillcut was built without the decoder for them</source>
        <translation>ist eine Datei eines Telefons oder einer Kamera, und dieses Stillcut wurde ohne den Decoder dafür gebaut</translation>
    </message>
    <message>
        <source>is damaged %1 s from its beginning: what is before is read</source>
        <translation>ist %1 s nach dem Anfang beschädigt: gelesen wird, was davor liegt</translation>
    </message>
    <message>
        <source>it follows from the indentation coefficient and the wear land</source>
        <translation>sie folgt aus dem Eindruckbeiwert und der Verschleißmarkenbreite</translation>
    </message>
    <message>
        <source>it is not clear whether &apos;%1&apos; has a decimal comma or thousands set apart</source>
        <translation>es ist nicht klar, ob &apos;%1&apos; ein Dezimalkomma oder abgetrennte Tausender hat</translation>
    </message>
    <message>
        <source>its container cannot be read</source>
        <translation>der Container kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>its header says %1 Hz, its times %2 Hz, which are taken</source>
        <translation>der Kopf sagt %1 Hz, die Zeiten %2 Hz, und diese gelten</translation>
    </message>
    <message>
        <source>its sampling rate or number of channels changes within it</source>
        <translation>Abtastrate oder Kanalzahl wechseln innerhalb der Datei</translation>
    </message>
    <message>
        <source>its times do not grow</source>
        <translation>die Zeiten wachsen nicht</translation>
    </message>
    <message>
        <source>line %1, the last, is cut off and left out</source>
        <translation>Zeile %1, die letzte, ist abgeschnitten und bleibt weg</translation>
    </message>
    <message>
        <source>measure both with the same sampling rate and length</source>
        <translation>beide mit gleicher Abtastrate und Länge messen</translation>
    </message>
    <message>
        <source>name every column</source>
        <translation>jede Spalte benennen</translation>
    </message>
    <message>
        <source>needs its distance from the face</source>
        <translation>braucht den Abstand von der Stirnfläche</translation>
    </message>
    <message>
        <source>needs the tool&apos;s diameter and stick-out</source>
        <translation>braucht Durchmesser und Auskraglänge des Werkzeugs</translation>
    </message>
    <message>
        <source>no decoder for its sound track</source>
        <translation>kein Decoder für die Tonspur</translation>
    </message>
    <message>
        <source>no sample of its sound track can be decoded</source>
        <translation>kein Abtastwert der Tonspur lässt sich dekodieren</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>zu wenig Speicher</translation>
    </message>
    <message>
        <source>open the .tdms file beside it</source>
        <translation>die .tdms-Datei daneben öffnen</translation>
    </message>
    <message>
        <source>open the recording that it was made from</source>
        <translation>die Aufzeichnung öffnen, aus der sie entstand</translation>
    </message>
    <message>
        <source>raise the lowest speed</source>
        <translation>die kleinste Drehzahl anheben</translation>
    </message>
    <message>
        <source>samples must be 8 to 1000</source>
        <translation>die Zahl der Proben muss 8 bis 1000 sein</translation>
    </message>
    <message>
        <source>save plain arrays with numpy.save or numpy.savez</source>
        <translation>einfache Felder mit numpy.save oder numpy.savez speichern</translation>
    </message>
    <message>
        <source>save the sheet as CSV</source>
        <translation>das Blatt als CSV speichern</translation>
    </message>
    <message>
        <source>semi-discretization needs teeth of one pitch and one helix</source>
        <translation>die Semidiskretisierung braucht Zähne gleicher Teilung und gleichen Dralls</translation>
    </message>
    <message>
        <source>semi-discretization with %1 cells is too coarse below %2 rpm: take %3 or more, or the exact method</source>
        <translation>Semidiskretisierung mit %1 Zellen ist unter %2 1/min zu grob: %3 oder mehr nehmen, oder das genaue Verfahren</translation>
    </message>
    <message>
        <source>some columns end after %1 of %2 rows, where the recording ends; --channel N reads one alone</source>
        <translation>einige Spalten enden nach %1 von %2 Zeilen, dort endet die Aufzeichnung; --channel N liest eine allein</translation>
    </message>
    <message>
        <source>take a smaller depth or other helix angles</source>
        <translation>eine kleinere Tiefe oder andere Drallwinkel wählen</translation>
    </message>
    <message>
        <source>teeth must be 1 to %1, not %2</source>
        <translation>die Zähnezahl muss 1 bis %1 sein, nicht %2</translation>
    </message>
    <message>
        <source>the HDF5 file was not closed by its writer</source>
        <translation>die HDF5-Datei wurde von ihrem Schreiber nicht geschlossen</translation>
    </message>
    <message>
        <source>the ZIP archive is damaged</source>
        <translation>das ZIP-Archiv ist beschädigt</translation>
    </message>
    <message>
        <source>the angles make it %1</source>
        <translation>aus den Winkeln folgt %1</translation>
    </message>
    <message>
        <source>the decoder cannot read it</source>
        <translation>der Decoder kann sie nicht lesen</translation>
    </message>
    <message>
        <source>the edges of two teeth meet at %1 mm</source>
        <translation>die Schneiden zweier Zähne treffen sich bei %1 mm</translation>
    </message>
    <message>
        <source>the exact method takes any</source>
        <translation>das genaue Verfahren nimmt beliebige</translation>
    </message>
    <message>
        <source>the exit angle must lie above the start angle</source>
        <translation>der Austrittswinkel muss über dem Eintrittswinkel liegen</translation>
    </message>
    <message>
        <source>the flutes are longer than the stick-out</source>
        <translation>die Nuten sind länger als die Auskraglänge</translation>
    </message>
    <message>
        <source>the flutes&apos; effective diameter must be 0.3 to 1 of the tool&apos;s</source>
        <translation>der wirksame Durchmesser der Nuten muss das 0,3- bis 1-Fache des Werkzeugs sein</translation>
    </message>
    <message>
        <source>the header does not say how much follows, as of a recorder that wrote into a pipe: all is read</source>
        <translation>der Kopf sagt nicht, wie viel folgt, wie bei einem Rekorder, der in eine Pipe schrieb: alles wird gelesen</translation>
    </message>
    <message>
        <source>the header&apos;s size is not true: it says %1 bytes, which is what 32 bits leave of %2, which are read</source>
        <translation>die Größe im Kopf stimmt nicht: er sagt %1 Bytes, was 32 Bit von %2 übrig lassen, die gelesen werden</translation>
    </message>
    <message>
        <source>the holder was measured with an exponential window: the damping is too high by %1 1/s</source>
        <translation>der Halter wurde mit einem Exponentialfenster gemessen: die Dämpfung ist um %1 1/s zu hoch</translation>
    </message>
    <message>
        <source>the holder&apos;s rotation was not measured and is left out: the tip is softer, and its frequencies are lower, than computed here; --cross measures it</source>
        <translation>die Drehung des Halters wurde nicht gemessen und bleibt weg: die Spitze ist weicher und ihre Frequenzen sind niedriger als hier berechnet; --cross misst sie</translation>
    </message>
    <message>
        <source>the speed range holds more lobes than can be looked at</source>
        <translation>der Drehzahlbereich enthält mehr Keulen, als betrachtet werden können</translation>
    </message>
    <message>
        <source>the tool needs 1 to 64 sections</source>
        <translation>das Werkzeug braucht 1 bis 64 Abschnitte</translation>
    </message>
    <message>
        <source>the tool&apos;s material is none</source>
        <translation>der Werkstoff des Werkzeugs ist keiner</translation>
    </message>
    <message>
        <source>the unit &apos;%1&apos; of its time is not known</source>
        <translation>die Einheit &apos;%1&apos; der Zeit ist nicht bekannt</translation>
    </message>
    <message>
        <source>the zeroth order leaves out process damping: its limits at low speed are too low</source>
        <translation>die nullte Ordnung lässt die Prozessdämpfung weg: ihre Grenzen bei kleinen Drehzahlen sind zu niedrig</translation>
    </message>
    <message>
        <source>the zeroth order needs teeth of one pitch and one helix</source>
        <translation>die nullte Ordnung braucht Zähne gleicher Teilung und gleichen Dralls</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>unpack it, and open what is in it</source>
        <translation>auspacken und öffnen, was darin ist</translation>
    </message>
    <message>
        <source>was not closed by its writer: what that had written so far is read</source>
        <translation>wurde von seinem Schreiber nicht geschlossen: gelesen wird, was bis dahin geschrieben war</translation>
    </message>
    <message>
        <source>what is clamped does not count</source>
        <translation>was gespannt ist, zählt nicht</translation>
    </message>
    <message>
        <source>what stands below the rows is left out: %1</source>
        <translation>was unter den Zeilen steht, bleibt weg: %1</translation>
    </message>
    <message>
        <source>with decimal commas, export with semicolons between the columns</source>
        <translation>bei Dezimalkommas mit Semikolons zwischen den Spalten exportieren</translation>
    </message>
    <message>
        <source>with this offset a part of the cut lies beyond the tool</source>
        <translation>bei diesem Versatz liegt ein Teil des Schnitts außerhalb des Werkzeugs</translation>
    </message>
    <message>
        <source>write it as CSV in Python: %1</source>
        <translation>in Python als CSV schreiben: %1</translation>
    </message>
    <message>
        <source>%1 s of air cutting</source>
        <translation>%1 s Luft</translation>
    </message>
    <message>
        <source>%1 samples a second are too few for vibration</source>
        <translation>%1 Abtastwerte je Sekunde sind zu wenig für Schwingungen</translation>
    </message>
    <message>
        <source>%1; take %2</source>
        <translation>%1; nehmen Sie %2</translation>
    </message>
    <message>
        <source>channel %1 (%2) is no vibration and was left out: %3</source>
        <translation>Kanal %1 (%2) ist keine Schwingung und blieb weg: %3</translation>
    </message>
    <message>
        <source>channel %1 (%2) was not in order for %3 s: %4</source>
        <translation>Kanal %1 (%2) war %3 s nicht in Ordnung: %4</translation>
    </message>
    <message>
        <source>chatter at %1 Hz from %2 s on</source>
        <translation>Rattern bei %1 Hz ab %2 s</translation>
    </message>
    <message>
        <source>chatter from %1 s on</source>
        <translation>Rattern ab %1 s</translation>
    </message>
    <message>
        <source>chatter can be detected up to %1 Hz</source>
        <translation>Rattern ist bis %1 Hz zu erkennen</translation>
    </message>
    <message>
        <source>it grows evenly and falls back, as an angle or a counter does</source>
        <translation>er wächst gleichmäßig und fällt zurück, wie ein Winkel oder ein Zähler</translation>
    </message>
    <message>
        <source>it is constant</source>
        <translation>er ist konstant</translation>
    </message>
    <message>
        <source>it knows two values only, as a tacho or a switch does</source>
        <translation>er kennt nur zwei Werte, wie ein Drehgeber oder ein Schalter</translation>
    </message>
    <message>
        <source>it only counts, as a row number or a time does</source>
        <translation>er zählt nur, wie eine Zeilennummer oder eine Zeit</translation>
    </message>
    <message>
        <source>judged %1 of %2 s</source>
        <translation>%1 von %2 s beurteilt</translation>
    </message>
    <message>
        <source>judged %1 of %2 s; the rest: %3</source>
        <translation>%1 von %2 s beurteilt; der Rest: %3</translation>
    </message>
    <message>
        <source>learning the stable cut</source>
        <translation>der stabile Schnitt wird gelernt</translation>
    </message>
    <message>
        <source>less depth</source>
        <translation>weniger Tiefe</translation>
    </message>
    <message>
        <source>less than %1 mm of depth</source>
        <translation>weniger als %1 mm Tiefe</translation>
    </message>
    <message>
        <source>no chatter</source>
        <translation>kein Rattern</translation>
    </message>
    <message>
        <source>no speed follows while the number of teeth is not known</source>
        <translation>ohne die Zahl der Schneiden folgt keine Drehzahl</translation>
    </message>
    <message>
        <source>no speed follows while the spindle speed is not known</source>
        <translation>ohne die Spindeldrehzahl folgt keine Drehzahl</translation>
    </message>
    <message>
        <source>no speed in reach is stable at a depth of %1 mm, %2 mm at %3 rpm would be</source>
        <translation>keine erreichbare Drehzahl ist bei %1 mm Tiefe stabil, %2 mm bei %3 1/min wären es</translation>
    </message>
    <message>
        <source>no stable speed lies between %1 and %2 rpm</source>
        <translation>zwischen %1 und %2 1/min liegt keine stabile Drehzahl</translation>
    </message>
    <message>
        <source>not judged: %1</source>
        <translation>nicht beurteilt: %1</translation>
    </message>
    <message>
        <source>not judged: no cut was measured</source>
        <translation>nicht beurteilt: es war kein Schnitt zu hören</translation>
    </message>
    <message>
        <source>not judged: only %1 of %2 s in the cut could be, mainly because %3</source>
        <translation>nicht beurteilt: nur %1 von %2 s im Schnitt waren zu beurteilen, vor allem weil: %3</translation>
    </message>
    <message>
        <source>samples are missing</source>
        <translation>Abtastwerte fehlen</translation>
    </message>
    <message>
        <source>stable speeds are only %1 rpm apart here, so that less depth is the surer way</source>
        <translation>stabile Drehzahlen liegen hier nur %1 1/min auseinander, weniger Tiefe ist der sicherere Weg</translation>
    </message>
    <message>
        <source>the frequency of the chatter is not known</source>
        <translation>die Frequenz des Ratterns ist nicht bekannt</translation>
    </message>
    <message>
        <source>the tool enters or leaves</source>
        <translation>das Werkzeug tritt ein oder aus</translation>
    </message>
    <message>
        <source>try %1 or %2 rpm (%3 or %4 waves of %5 Hz between two teeth instead of %6), or %7</source>
        <translation>versuchen Sie %1 oder %2 1/min (%3 oder %4 Wellen von %5 Hz zwischen zwei Schneiden statt %6) oder %7</translation>
    </message>
    <message>
        <source>try %1 rpm (%2 waves of %3 Hz between two teeth instead of %4), or %5</source>
        <translation>versuchen Sie %1 1/min (%2 Wellen von %3 Hz zwischen zwei Schneiden statt %4) oder %5</translation>
    </message>
    <message>
        <source>try %1 rpm (stable from %2 to %3 rpm by the lobes), or %4</source>
        <translation>versuchen Sie %1 1/min (nach den Stabilitätskarten stabil von %2 bis %3 1/min) oder %4</translation>
    </message>
    <message>
        <source>A simulated tap test: hammer and two accelerometers at the tip of a tool: axis, interval_s</source>
        <translation>Ein simulierter Klopfversuch: Hammer und zwei Beschleunigungssensoren an der Werkzeugspitze: axis, interval_s</translation>
    </message>
    <message>
        <source>the machine has no watchdog: a process of its own brings the overrides back if this program dies; they stay where both are killed at once, or the cable goes</source>
        <translation>die Maschine hat keinen Watchdog: stirbt dieses Programm, bringt ein eigener Prozess die Overrides zurück; sie bleiben, wenn beide zugleich sterben oder das Kabel abgeht</translation>
    </message>
    <message>
        <source>as the run that holds the machine tells: nothing more was asked</source>
        <translation>wie der laufende Betrieb sagt, der die Maschine hält: nichts weiter wurde gefragt</translation>
    </message>
    <message>
        <source>Aluminium, wrought</source>
        <translation>Aluminium, geknetet</translation>
    </message>
    <message>
        <source>Aluminium, cast</source>
        <translation>Aluminium, gegossen</translation>
    </message>
    <message>
        <source>Steel, unalloyed</source>
        <translation>Stahl, unlegiert</translation>
    </message>
    <message>
        <source>Steel, alloyed, tempered</source>
        <translation>Stahl, legiert, vergütet</translation>
    </message>
    <message>
        <source>Cast iron, grey</source>
        <translation>Grauguss</translation>
    </message>
    <message>
        <source>Titanium alloy</source>
        <translation>Titanlegierung</translation>
    </message>
    <message>
        <source>stillcut-status, beside any screen, for &apos;linuxcnc&apos;</source>
        <translation>stillcut-status, neben jeder Oberfläche, für &apos;linuxcnc&apos;</translation>
    </message>
    <message>
        <source>Status port</source>
        <translation>Status-Port</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
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
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is raw, with a scale that is no straight line</source>
        <translation>&apos;%1&apos; ist roh, mit einer Skala, die keine Gerade ist</translation>
    </message>
    <message>
        <source>&apos;status_port&apos; needs &apos;hal_component_port&apos;</source>
        <translation>&apos;status_port&apos; braucht &apos;hal_component_port&apos;</translation>
    </message>
    <message>
        <source>a header makes no sense</source>
        <translation>ein Kopf ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>a response along x or y is needed</source>
        <translation>ein Frequenzgang entlang x oder y wird gebraucht</translation>
    </message>
    <message>
        <source>a response needs two lines or more, each with a frequency</source>
        <translation>ein Frequenzgang braucht zwei Linien oder mehr, jede mit einer Frequenz</translation>
    </message>
    <message>
        <source>a sweep changes the speed by up to 20 % a second</source>
        <translation>ein Durchlauf ändert die Drehzahl um bis zu 20 % je Sekunde</translation>
    </message>
    <message>
        <source>a sweep needs the speed where it ends</source>
        <translation>ein Durchlauf braucht seine Enddrehzahl</translation>
    </message>
    <message>
        <source>a tool with another or an uneven pitch</source>
        <translation>ein Werkzeug mit anderer oder ungleicher Teilung</translation>
    </message>
    <message>
        <source>a tooth harmonic meets a resonance: take the speed off it</source>
        <translation>eine Zahnharmonische trifft eine Resonanz: Drehzahl davon weg</translation>
    </message>
    <message>
        <source>a tooth harmonic meets a resonance: take the speed off it, as %1 rpm</source>
        <translation>eine Zahnharmonische trifft eine Resonanz: Drehzahl davon weg, etwa %1 1/min</translation>
    </message>
    <message>
        <source>an incline ends deeper than it begins</source>
        <translation>ein Schrägschnitt endet tiefer als er beginnt</translation>
    </message>
    <message>
        <source>another speed: %1 rpm</source>
        <translation>andere Drehzahl: %1 1/min</translation>
    </message>
    <message>
        <source>cannot be kept for the screen</source>
        <translation>kann für den Bildschirm nicht gehalten werden</translation>
    </message>
    <message>
        <source>cannot be read again</source>
        <translation>kann nicht noch einmal gelesen werden</translation>
    </message>
    <message>
        <source>chatter frequency must lie between 0 and 100 kHz</source>
        <translation>Ratterfrequenz muss zwischen 0 und 100 kHz liegen</translation>
    </message>
    <message>
        <source>check runout and balance</source>
        <translation>Rundlauf und Wuchtung prüfen</translation>
    </message>
    <message>
        <source>clearance must lie above 0 and up to 1000 mm</source>
        <translation>Sicherheitsabstand muss über 0 und bis 1000 mm liegen</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>depth must lie above 0 and up to 1000 mm</source>
        <translation>Tiefe muss über 0 und bis 1000 mm liegen</translation>
    </message>
    <message>
        <source>diameter must lie above 0 and up to 1000 mm</source>
        <translation>Durchmesser muss über 0 und bis 1000 mm liegen</translation>
    </message>
    <message>
        <source>doubt must lie between 0 and 0.5</source>
        <translation>der Zweifel muss zwischen 0 und 0.5 liegen</translation>
    </message>
    <message>
        <source>export it scaled, or as CSV</source>
        <translation>skaliert exportieren, oder als CSV</translation>
    </message>
    <message>
        <source>feed per tooth must lie above 0 and up to 10 mm</source>
        <translation>Zahnvorschub muss über 0 und bis 10 mm liegen</translation>
    </message>
    <message>
        <source>field &apos;%1&apos; is missing or of the wrong kind</source>
        <translation>Feld &apos;%1&apos; fehlt oder ist von falscher Art</translation>
    </message>
    <message>
        <source>gives no answer</source>
        <translation>gibt keine Antwort</translation>
    </message>
    <message>
        <source>has a hammer or a frequency response</source>
        <translation>hat einen Hammer oder einen Frequenzgang</translation>
    </message>
    <message>
        <source>holds interleaved values that are no numbers</source>
        <translation>enthält verschachtelte Werte, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>holds modes alone</source>
        <translation>enthält nur Moden</translation>
    </message>
    <message>
        <source>holds no channel of numbers</source>
        <translation>enthält keinen Kanal mit Zahlen</translation>
    </message>
    <message>
        <source>holds no cut &apos;%1&apos;</source>
        <translation>enthält keinen Schnitt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>holds no hit</source>
        <translation>enthält keinen Schlag</translation>
    </message>
    <message>
        <source>holds no values</source>
        <translation>enthält keine Werte</translation>
    </message>
    <message>
        <source>holds unscaled values of a DAQmx device, which are not read</source>
        <translation>enthält unskalierte Werte eines DAQmx-Geräts, die nicht gelesen werden</translation>
    </message>
    <message>
        <source>is a damaged TDMS file</source>
        <translation>ist eine beschädigte TDMS-Datei</translation>
    </message>
    <message>
        <source>is a damaged spreadsheet</source>
        <translation>ist eine beschädigte Tabelle</translation>
    </message>
    <message>
        <source>is a store of a newer version of Stillcut</source>
        <translation>ist ein Speicher einer neueren Stillcut-Version</translation>
    </message>
    <message>
        <source>is no line of evidence</source>
        <translation>ist keine Zeile mit einem Schnitt</translation>
    </message>
    <message>
        <source>is no store of cuts</source>
        <translation>ist kein Schnittspeicher</translation>
    </message>
    <message>
        <source>is the installation complete?</source>
        <translation>ist die Installation vollständig?</translation>
    </message>
    <message>
        <source>it belongs to another program</source>
        <translation>er gehört einem anderen Programm</translation>
    </message>
    <message>
        <source>it was quiet at %1 rpm</source>
        <translation>bei %1 1/min war es ruhig</translation>
    </message>
    <message>
        <source>its decay fits nothing that was learned so far</source>
        <translation>sein Abklingen passt zu nichts bisher Gelerntem</translation>
    </message>
    <message>
        <source>its decay is too uncertain</source>
        <translation>sein Abklingen ist zu unsicher</translation>
    </message>
    <message>
        <source>its schema is not %1</source>
        <translation>sein Schema ist nicht %1</translation>
    </message>
    <message>
        <source>its speed lies outside what is looked at</source>
        <translation>seine Drehzahl liegt außerhalb des betrachteten Bereichs</translation>
    </message>
    <message>
        <source>its values lie too scattered</source>
        <translation>seine Werte liegen zu verstreut</translation>
    </message>
    <message>
        <source>length must lie above 0 and up to 100 m</source>
        <translation>Länge muss über 0 und bis 100 m liegen</translation>
    </message>
    <message>
        <source>less depth: %1 mm</source>
        <translation>weniger Tiefe: %1 mm</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>machine and tool must be named</source>
        <translation>Maschine und Werkzeug müssen benannt sein</translation>
    </message>
    <message>
        <source>modes</source>
        <translation>Moden</translation>
    </message>
    <message>
        <source>no free vibration stands out of the noise</source>
        <translation>keine freie Schwingung hebt sich vom Rauschen ab</translation>
    </message>
    <message>
        <source>no recording is open</source>
        <translation>keine Aufnahme ist offen</translation>
    </message>
    <message>
        <source>one JSON object a line</source>
        <translation>ein JSON-Objekt je Zeile</translation>
    </message>
    <message>
        <source>one tooth has no pitch to choose</source>
        <translation>ein Zahn hat keine Teilung zu wählen</translation>
    </message>
    <message>
        <source>pitches are chosen for teeth of one helix</source>
        <translation>Teilungen werden für Zähne eines Dralls gewählt</translation>
    </message>
    <message>
        <source>say what the tool cuts: %1</source>
        <translation>sagen, was das Werkzeug schneidet: %1</translation>
    </message>
    <message>
        <source>spectra</source>
        <translation>Spektren</translation>
    </message>
    <message>
        <source>speed must lie above 0 and up to 1e6 rpm</source>
        <translation>Drehzahl muss über 0 und bis 1e6 1/min liegen</translation>
    </message>
    <message>
        <source>stick-out must lie between 0 and 2000 mm</source>
        <translation>Auskraglänge muss zwischen 0 und 2000 mm liegen</translation>
    </message>
    <message>
        <source>stillcut-cli materials lists them</source>
        <translation>stillcut-cli materials listet sie</translation>
    </message>
    <message>
        <source>stillcut-status only tells; the overrides go through stillcut-hal</source>
        <translation>stillcut-status meldet nur; die Overrides laufen über stillcut-hal</translation>
    </message>
    <message>
        <source>take a shorter range of speeds, or less feed</source>
        <translation>kleineren Drehzahlbereich oder weniger Vorschub wählen</translation>
    </message>
    <message>
        <source>teeth must be 1 to 200</source>
        <translation>Zähne müssen 1 bis 200 sein</translation>
    </message>
    <message>
        <source>the file was not finished; what was written until then is read</source>
        <translation>die Datei wurde nicht beendet; gelesen wird, was bis dahin geschrieben war</translation>
    </message>
    <message>
        <source>the free vibration is not the same throughout the cut</source>
        <translation>die freie Schwingung bleibt im Schnitt nicht gleich</translation>
    </message>
    <message>
        <source>the frequencies of a response must rise from above 0</source>
        <translation>die Frequenzen eines Frequenzgangs müssen von über 0 an steigen</translation>
    </message>
    <message>
        <source>the highest speed must lie above the lowest, both above 0</source>
        <translation>die höchste Drehzahl muss über der niedrigsten liegen, beide über 0</translation>
    </message>
    <message>
        <source>the largest depth must lie above 0</source>
        <translation>die größte Tiefe muss über 0 liegen</translation>
    </message>
    <message>
        <source>the last %1 cuts do not fit the %2 before: another tool, holder or clamping? The lobes were started anew</source>
        <translation>die letzten %1 Schnitte passen nicht zu den %2 davor: anderes Werkzeug, Halter oder Spannung? Die Keulen wurden neu begonnen</translation>
    </message>
    <message>
        <source>the recording</source>
        <translation>die Aufnahme</translation>
    </message>
    <message>
        <source>the responses have no frequencies in common</source>
        <translation>die Frequenzgänge haben keine Frequenzen gemeinsam</translation>
    </message>
    <message>
        <source>the risk must lie between 0 and 1</source>
        <translation>das Risiko muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>the sound output has failed: %1</source>
        <translation>die Tonausgabe ist ausgefallen: %1</translation>
    </message>
    <message>
        <source>the speed is not known or the sampling rate too low</source>
        <translation>die Drehzahl ist unbekannt oder die Abtastrate zu niedrig</translation>
    </message>
    <message>
        <source>the steady cut is too short</source>
        <translation>der gleichmäßige Schnitt ist zu kurz</translation>
    </message>
    <message>
        <source>the store of cuts cannot be opened</source>
        <translation>der Schnittspeicher lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the store of cuts cannot be used</source>
        <translation>der Schnittspeicher ist nicht benutzbar</translation>
    </message>
    <message>
        <source>the sweep needs %1 mm of material</source>
        <translation>der Durchlauf braucht %1 mm Material</translation>
    </message>
    <message>
        <source>the table of materials has no &apos;%1&apos;</source>
        <translation>Werkstofftabelle kennt &apos;%1&apos; nicht</translation>
    </message>
    <message>
        <source>there are none to keep</source>
        <translation>keine zum Behalten</translation>
    </message>
    <message>
        <source>there is no such channel</source>
        <translation>diesen Kanal gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such channel in the file</source>
        <translation>diesen Kanal gibt es in der Datei nicht</translation>
    </message>
    <message>
        <source>this Stillcut was built without sound output</source>
        <translation>dieses Stillcut wurde ohne Tonausgabe gebaut</translation>
    </message>
    <message>
        <source>this computer has no sound output: %1</source>
        <translation>dieser Rechner hat keine Tonausgabe: %1</translation>
    </message>
    <message>
        <source>this cut was quiet before: is the tool worn, or loose?</source>
        <translation>dieser Schnitt war früher ruhig: Werkzeug stumpf oder lose?</translation>
    </message>
    <message>
        <source>this tool chattered at %1 rpm</source>
        <translation>dieses Werkzeug ratterte bei %1 1/min</translation>
    </message>
    <message>
        <source>too little is known of this tool</source>
        <translation>von diesem Werkzeug ist zu wenig bekannt</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>update this program</source>
        <translation>dieses Programm aktualisieren</translation>
    </message>
    <message>
        <source>vary the spindle speed by %1 % with a period of %2 s: in simulation this quiets it</source>
        <translation>Drehzahl um %1 % mit einer Periode von %2 s ändern: in der Simulation wird es damit ruhig</translation>
    </message>
    <message>
        <source>cannot be run again</source>
        <translation>kann nicht noch einmal laufen</translation>
    </message>
    <message>
        <source>cut.model is the file with modes and material</source>
        <translation>cut.model ist die Datei mit Moden und Werkstoff</translation>
    </message>
    <message>
        <source>depth of cut</source>
        <translation>Schnitttiefe</translation>
    </message>
    <message>
        <source>names no model of its cut</source>
        <translation>nennt kein Modell seines Schnitts</translation>
    </message>
    <message>
        <source>none is entered</source>
        <translation>keine eingegeben</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>the force is not proportional to the chip: taken as it is at a chip of %1 um</source>
        <translation>die Kraft ist nicht proportional zum Span: genommen wie bei einem Span von %1 um</translation>
    </message>
    <message>
        <source>type frequency, damping and stiffness, or open a file with modes</source>
        <translation>Frequenz, Dämpfung und Steifigkeit eintippen oder eine Datei mit Moden öffnen</translation>
    </message>
    <message>
        <source>%1 samples a second are more than can be judged</source>
        <translation>%1 Abtastwerte je Sekunde sind mehr, als beurteilt werden können</translation>
    </message>
    <message>
        <source>a pipe is read as the standard input: - &lt; FILE</source>
        <translation>eine Pipe wird als Standardeingabe gelesen: - &lt; FILE</translation>
    </message>
    <message>
        <source>a row is a time in s and a speed in rpm</source>
        <translation>eine Zeile ist eine Zeit in s und eine Drehzahl in U/min</translation>
    </message>
    <message>
        <source>choose at most 32 with --channel N[,N]</source>
        <translation>mit --channel N[,N] höchstens 32 auswählen</translation>
    </message>
    <message>
        <source>damaged, or cut off: what records into it writes its index when it ends</source>
        <translation>beschädigt oder abgeschnitten: ihr Verzeichnis wird erst am Ende der Aufnahme geschrieben</translation>
    </message>
    <message>
        <source>ends after %1 of %2 s: what is there is read</source>
        <translation>endet nach %1 von %2 s: gelesen wird, was da ist</translation>
    </message>
    <message>
        <source>export each with its channels as a file of its own, or give --rate HZ</source>
        <translation>jede mit ihren Kanälen als eigene Datei exportieren, oder --rate HZ angeben</translation>
    </message>
    <message>
        <source>export those of each rate as a file of their own</source>
        <translation>die Kanäle jeder Rate als eigene Datei exportieren</translation>
    </message>
    <message>
        <source>format it as a time of day and export again, or give --rate HZ</source>
        <translation>als Uhrzeit formatieren und neu exportieren, oder --rate HZ angeben</translation>
    </message>
    <message>
        <source>has %1 channels, more than are judged at once</source>
        <translation>hat %1 Kanäle, mehr als auf einmal beurteilt werden</translation>
    </message>
    <message>
        <source>has no sheet &apos;%1&apos;</source>
        <translation>hat kein Blatt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>it is not clear whether &apos;%1&apos; has a decimal point or thousands set apart</source>
        <translation>unklar, ob &apos;%1&apos; einen Dezimalpunkt oder abgesetzte Tausender hat</translation>
    </message>
    <message>
        <source>its channels have several rates</source>
        <translation>ihre Kanäle haben mehrere Raten</translation>
    </message>
    <message>
        <source>its coding is not known; convert it to WAV: ffmpeg -i FILE cut.wav</source>
        <translation>ihre Kodierung ist unbekannt; in WAV umwandeln: ffmpeg -i FILE cut.wav</translation>
    </message>
    <message>
        <source>its columns have times of their own: &apos;%1&apos; goes in other steps</source>
        <translation>ihre Spalten haben eigene Zeiten: &apos;%1&apos; geht in anderen Schritten</translation>
    </message>
    <message>
        <source>its header is damaged, or its coding is not known</source>
        <translation>ihr Kopf ist beschädigt, oder ihre Kodierung ist unbekannt</translation>
    </message>
    <message>
        <source>its time seems to be in days, as spreadsheets count them</source>
        <translation>ihre Zeit scheint in Tagen zu sein, wie Tabellenprogramme zählen</translation>
    </message>
    <message>
        <source>no sample of it can be decoded</source>
        <translation>kein Abtastwert lässt sich dekodieren</translation>
    </message>
    <message>
        <source>none of its sheets holds rows of numbers: %1</source>
        <translation>keines ihrer Blätter enthält Zeilen mit Zahlen: %1</translation>
    </message>
    <message>
        <source>nothing in it is known as sound</source>
        <translation>nichts darin ist als Ton bekannt</translation>
    </message>
    <message>
        <source>of its %1 sheets &apos;%2&apos; is read; FILE:/NAME reads another</source>
        <translation>von ihren %1 Blättern wird &apos;%2&apos; gelesen; FILE:/NAME liest ein anderes</translation>
    </message>
    <message>
        <source>only HDF5, MATLAB, NumPy, TDMS and Excel files have places inside</source>
        <translation>nur HDF5-, MATLAB-, NumPy-, TDMS- und Excel-Dateien haben Stellen darin</translation>
    </message>
    <message>
        <source>the header promises %1 bytes, the file holds %2, which are read: its recorder did not end it</source>
        <translation>der Kopf verspricht %1 Bytes, die Datei enthält %2, die gelesen werden: ihr Aufzeichner hat sie nicht beendet</translation>
    </message>
    <message>
        <source>write 0 in its place, or read the other channels with --channel N</source>
        <translation>an seiner Stelle 0 schreiben, oder mit --channel N die anderen Kanäle lesen</translation>
    </message>
    <message>
        <source>write NaN on every channel where samples are missing, or leave this one out</source>
        <translation>NaN in jeden Kanal schreiben, wo Abtastwerte fehlen, oder diesen weglassen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has more than two dimensions</source>
        <translation>„%1“ hat mehr als zwei Dimensionen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a table of records, which is not read</source>
        <translation>„%1“ ist eine Tabelle von Datensätzen, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>a shorter way to the machine, or registers that lie side by side</source>
        <translation>ein kürzerer Weg zur Maschine, oder Register, die nebeneinander liegen</translation>
    </message>
    <message>
        <source>an answer takes %1 ms, and %2 of them tell all: it is too old by then</source>
        <translation>eine Antwort braucht %1 ms, und erst %2 davon sagen alles: dann ist es zu alt</translation>
    </message>
    <message>
        <source>are the unit, the register map and its answer_ms right?</source>
        <translation>stimmen Adresse (unit), Registertabelle und ihr answer_ms?</translation>
    </message>
    <message>
        <source>from %1 rpm on it is possible</source>
        <translation>ab %1 U/min ist es möglich</translation>
    </message>
    <message>
        <source>holds &apos;%1&apos;, a cell array or an array of structs, which is not read</source>
        <translation>enthält „%1“, ein Cell-Array oder ein Array von Strukturen, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>in line %1, &apos;%2&apos;, &apos;%3&apos; is no number; is this a recording?</source>
        <translation>in Zeile %1, „%2“, ist „%3“ keine Zahl; ist das eine Aufzeichnung?</translation>
    </message>
    <message>
        <source>is a MATLAB file of version 4, which is not read</source>
        <translation>ist eine MATLAB-Datei der Version 4, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>is a table of text, whatever its name says</source>
        <translation>ist eine Texttabelle, was auch immer sein Name sagt</translation>
    </message>
    <message>
        <source>it counts the rows</source>
        <translation>es zählt die Zeilen</translation>
    </message>
    <message>
        <source>it has %1 numbers where the recording has %2</source>
        <translation>es hat %1 Zahlen, die Aufzeichnung %2</translation>
    </message>
    <message>
        <source>it has no unit, where other columns have one</source>
        <translation>es hat keine Einheit, andere Spalten haben eine</translation>
    </message>
    <message>
        <source>it holds no row of numbers that is read</source>
        <translation>es enthält keine Zahlenreihe, die gelesen wird</translation>
    </message>
    <message>
        <source>it holds times</source>
        <translation>es enthält Zeiten</translation>
    </message>
    <message>
        <source>it holds words</source>
        <translation>es enthält Wörter</translation>
    </message>
    <message>
        <source>it is a speed of the spindle</source>
        <translation>es ist eine Drehzahl der Spindel</translation>
    </message>
    <message>
        <source>it is mains hum of %1 Hz and little else, look at its shield and ground</source>
        <translation>er enthält fast nur Netzbrummen von %1 Hz, Schirm und Erdung prüfen</translation>
    </message>
    <message>
        <source>it is not clear whether the rate &apos;%1&apos; of its header is a fraction or has thousands set apart</source>
        <translation>es ist nicht klar, ob die Rate „%1“ in seinem Kopf ein Bruch ist oder abgesetzte Tausender hat</translation>
    </message>
    <message>
        <source>its data sets have several rates</source>
        <translation>seine Datensätze haben mehrere Raten</translation>
    </message>
    <message>
        <source>its name or its unit says that it is no vibration</source>
        <translation>sein Name oder seine Einheit sagt, dass es keine Schwingung ist</translation>
    </message>
    <message>
        <source>its name says that it is no vibration</source>
        <translation>sein Name sagt, dass es keine Schwingung ist</translation>
    </message>
    <message>
        <source>its times &apos;%1&apos; have no unit: seconds are assumed</source>
        <translation>seine Zeiten „%1“ haben keine Einheit: Sekunden werden angenommen</translation>
    </message>
    <message>
        <source>its times are too coarse for its rows, several of which share one: they are taken as evenly spaced by the rate of its header, %1 Hz</source>
        <translation>seine Zeiten sind zu grob für seine Zeilen, von denen mehrere dieselbe haben: sie gelten als gleichmäßig mit der Rate seines Kopfes, %1 Hz</translation>
    </message>
    <message>
        <source>its times have no unit: seconds are assumed</source>
        <translation>seine Zeiten haben keine Einheit: Sekunden werden angenommen</translation>
    </message>
    <message>
        <source>its unit &apos;%1&apos; is none of a vibration</source>
        <translation>seine Einheit „%1“ ist keine einer Schwingung</translation>
    </message>
    <message>
        <source>most of its cells hold no number</source>
        <translation>die meisten seiner Zellen enthalten keine Zahl</translation>
    </message>
    <message>
        <source>name one of them: %1</source>
        <translation>einen davon nennen: %1</translation>
    </message>
    <message>
        <source>save each of its columns as a data set of its own</source>
        <translation>jede ihrer Spalten als eigenen Datensatz sichern</translation>
    </message>
    <message>
        <source>save it in MATLAB with -v7: save cut.mat -v7</source>
        <translation>in MATLAB mit -v7 sichern: save cut.mat -v7</translation>
    </message>
    <message>
        <source>save its numbers as plain variables in MATLAB: x = c{1}; save cut.mat x fs</source>
        <translation>die Zahlen in MATLAB als einfache Variablen sichern: x = c{1}; save cut.mat x fs</translation>
    </message>
    <message>
        <source>save samples by channels, one block behind the other</source>
        <translation>Werte mal Kanäle sichern, einen Block hinter dem anderen</translation>
    </message>
    <message>
        <source>%1 rpm is too low for teeth that differ or have a shape</source>
        <translation>%1 U/min ist zu niedrig für Zähne, die sich unterscheiden oder eine Form haben</translation>
    </message>
    <message>
        <source>a direction is three numbers: along the feed, into the part, along the cutting speed</source>
        <translation>Eine Richtung sind drei Zahlen: entlang des Vorschubs, in das Werkstück hinein, entlang der Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>a direction is two or three numbers, along x, y and z</source>
        <translation>Eine Richtung sind zwei oder drei Zahlen, entlang x, y und z</translation>
    </message>
    <message>
        <source>a turning cut has no tool that turns: [turning] says it all</source>
        <translation>Beim Drehen dreht sich kein Werkzeug: [turning] sagt alles</translation>
    </message>
    <message>
        <source>at least one speed is needed</source>
        <translation>Mindestens eine Drehzahl ist nötig</translation>
    </message>
    <message>
        <source>edges that stand have no pitch, helix or runout</source>
        <translation>Schneiden, die stehen, haben weder Teilung noch Drall noch Rundlauffehler</translation>
    </message>
    <message>
        <source>give the feed per tooth</source>
        <translation>Vorschub je Zahn angeben</translation>
    </message>
    <message>
        <source>is a turning cut, and this page enters milling cuts</source>
        <translation>ist ein Drehschnitt, und auf dieser Seite werden Fräsungen eingegeben</translation>
    </message>
    <message>
        <source>lobes and advice do</source>
        <translation>Stabilitätskarten und Empfehlungen tun es</translation>
    </message>
    <message>
        <source>no mode moves the edge across the cut or along the cutting speed</source>
        <translation>Keine Mode bewegt die Schneide quer zum Schnitt oder entlang der Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>no mode moves the tool along x or y</source>
        <translation>Keine Mode bewegt das Werkzeug entlang x oder y</translation>
    </message>
    <message>
        <source>one number for each of the speeds is needed</source>
        <translation>Für jede der Drehzahlen ist eine Zahl nötig</translation>
    </message>
    <message>
        <source>semi-discretization takes no corner radius and no serration</source>
        <translation>Die Semidiskretisierung nimmt weder Eckenradius noch verzahnte Schneide</translation>
    </message>
    <message>
        <source>speeds below %1 rpm are unknown: for teeth that differ or have a shape the exact method does not reach lower</source>
        <translation>Drehzahlen unter %1 U/min sind unbekannt: für Zähne, die sich unterscheiden oder eine Form haben, reicht das exakte Verfahren nicht tiefer</translation>
    </message>
    <message>
        <source>stillcut-cli lobes takes it</source>
        <translation>stillcut-cli lobes nimmt ihn</translation>
    </message>
    <message>
        <source>the corner radius must lie between 0 and half the diameter</source>
        <translation>Der Eckenradius muss zwischen 0 und dem halben Durchmesser liegen</translation>
    </message>
    <message>
        <source>the edge&apos;s angle to the feed must lie in 5 to 150 degrees</source>
        <translation>Der Winkel der Schneide zum Vorschub muss zwischen 5 und 150 Grad liegen</translation>
    </message>
    <message>
        <source>the serration needs one phase per tooth</source>
        <translation>Die Verzahnung der Schneide braucht eine Phase je Zahn</translation>
    </message>
    <message>
        <source>the serration&apos;s amplitude must be above zero and below a quarter of the diameter</source>
        <translation>Die Amplitude der Verzahnung der Schneide muss über null und unter einem Viertel des Durchmessers liegen</translation>
    </message>
    <message>
        <source>the serration&apos;s phases must be finite</source>
        <translation>Die Phasen der Verzahnung der Schneide müssen endlich sein</translation>
    </message>
    <message>
        <source>the serration&apos;s wave length must be above zero</source>
        <translation>Die Wellenlänge der Verzahnung der Schneide muss über null liegen</translation>
    </message>
    <message>
        <source>the simulation takes no corner radius and no serration</source>
        <translation>Die Simulation nimmt weder Eckenradius noch verzahnte Schneide</translation>
    </message>
    <message>
        <source>the speeds of a mode must rise from 0 or more</source>
        <translation>Die Drehzahlen einer Mode müssen ab 0 oder mehr ansteigen</translation>
    </message>
    <message>
        <source>the zeroth order takes no corner radius and no serration</source>
        <translation>Die nullte Ordnung nimmt weder Eckenradius noch verzahnte Schneide</translation>
    </message>
    <message>
        <source>what one edge feels across, the edge opposite feels the other way</source>
        <translation>Was eine Schneide quer spürt, spürt die gegenüber umgekehrt</translation>
    </message>
    <message>
        <source>which teeth of a serrated tool cut depends on the feed</source>
        <translation>Welche Zähne eines Werkzeugs mit verzahnter Schneide schneiden, hängt vom Vorschub ab</translation>
    </message>
    <message>
        <source>with several edges the modes may move along the feed and the cutting speed only</source>
        <translation>Bei mehreren Schneiden dürfen sich die Moden nur entlang des Vorschubs und der Schnittgeschwindigkeit bewegen</translation>
    </message>
    <message>
        <source>&apos;stillcut-cli modal&apos; and the page Tap test read it</source>
        <translation>&apos;stillcut-cli modal&apos; und die Seite Klopfen lesen ihn</translation>
    </message>
    <message>
        <source>a coherence</source>
        <translation>eine Kohärenz</translation>
    </message>
    <message>
        <source>a frequency response</source>
        <translation>einen Frequenzgang</translation>
    </message>
    <message>
        <source>a function of type %1</source>
        <translation>eine Funktion der Art %1</translation>
    </message>
    <message>
        <source>a spectrum</source>
        <translation>ein Spektrum</translation>
    </message>
    <message>
        <source>another Stillcut could not be told from none</source>
        <translation>ein anderes Stillcut wäre von keinem nicht zu unterscheiden</translation>
    </message>
    <message>
        <source>at least 100 are needed; is its time not in seconds? --time-unit or --rate says so</source>
        <translation>mindestens 100 sind nötig; ist die Zeit nicht in Sekunden? --time-unit oder --rate sagt es</translation>
    </message>
    <message>
        <source>at most 1000000; is its time not in seconds? --time-unit or --rate says so</source>
        <translation>höchstens 1000000; ist die Zeit nicht in Sekunden? --time-unit oder --rate sagt es</translation>
    </message>
    <message>
        <source>export the samples over time that it was made of</source>
        <translation>die Messwerte über der Zeit ausgeben, aus denen es entstand</translation>
    </message>
    <message>
        <source>holds a time stamp that makes no sense</source>
        <translation>enthält einen sinnlosen Zeitstempel</translation>
    </message>
    <message>
        <source>is a spectrum and no recording: &apos;%1&apos; holds frequencies</source>
        <translation>ist ein Spektrum und keine Aufzeichnung: &apos;%1&apos; enthält Frequenzen</translation>
    </message>
    <message>
        <source>is no recording: it holds %1</source>
        <translation>ist keine Aufzeichnung: sie enthält %1</translation>
    </message>
    <message>
        <source>is read without [write.heartbeat]</source>
        <translation>wird ohne [write.heartbeat] gelesen</translation>
    </message>
    <message>
        <source>it has another rate or length</source>
        <translation>er hat eine andere Rate oder Länge</translation>
    </message>
    <message>
        <source>it holds %1</source>
        <translation>er enthält %1</translation>
    </message>
    <message>
        <source>its time has no unit; its steps of %1 would be %2 Hz in seconds</source>
        <translation>ihre Zeit hat keine Einheit; ihre Schritte von %1 wären in Sekunden %2 Hz</translation>
    </message>
    <message>
        <source>open the samples that it was made of; a frequency response goes into the tap test</source>
        <translation>die Messwerte öffnen, aus denen es entstand; ein Frequenzgang gehört auf die Seite Klopfen</translation>
    </message>
    <message>
        <source>say --time-unit %1, or s if it is that slow</source>
        <translation>--time-unit %1 sagen, oder s, wenn sie so langsam ist</translation>
    </message>
    <message>
        <source>say --time-unit s, ms, us or ns, or give --rate HZ</source>
        <translation>--time-unit s, ms, us oder ns sagen, oder --rate HZ angeben</translation>
    </message>
    <message>
        <source>two responses and no word of the force: right only if x and y were each hit along themselves</source>
        <translation>zwei Antworten, und von der Kraft steht nichts da: richtig nur, wenn x und y je in ihrer Richtung angeschlagen wurden</translation>
    </message>
</context>
<context>
    <name>Learned</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>Next most useful cut: %1, because it tells most (stable with %2).</source>
        <translation>Nützlichster nächster Schnitt: %1, weil er am meisten verrät (stabil mit %2).</translation>
    </message>
    <message>
        <source>Next most useful cut: %1, because its outcome (stable with %2) may raise the removal rate most: %3 expected.</source>
        <translation>Nützlichster nächster Schnitt: %1, weil sein Ausgang (stabil mit %2) das Zeitspanvolumen am meisten heben kann: %3 erwartet.</translation>
    </message>
    <message>
        <source>Nothing is learned from these cuts: say machine, tool, teeth, depth and modes under Set up.</source>
        <translation>Aus diesen Schnitten wird nichts gelernt: Maschine, Werkzeug, Zähne, Tiefe und Moden unter Einrichten angeben.</translation>
    </message>
    <message>
        <source>Learned from cuts: nothing yet. Cut with this tool: every judged cut is kept and counts here.</source>
        <translation>Aus Schnitten gelernt: noch nichts. Mit diesem Werkzeug schneiden: jeder beurteilte Schnitt wird aufgehoben und zählt hier.</translation>
    </message>
    <message>
        <source>Learned from cuts: %1</source>
        <translation>Aus Schnitten gelernt: %1</translation>
    </message>
    <message>
        <source>Learned from %1 judged cuts (%2 with chatter) and the tool&apos;s modes.</source>
        <translation>Gelernt aus %1 beurteilten Schnitten (%2 mit Rattern) und den Moden des Werkzeugs.</translation>
    </message>
    <message>
        <source>%1 older ones are set aside: the newest indicate another tool.</source>
        <translation>%1 ältere zählen nicht mehr: die neuesten deuten auf ein anderes Werkzeug.</translation>
    </message>
    <message>
        <source>Recommended at a risk of %1: %2.</source>
        <translation>Empfohlen bei einem Risiko von %1: %2.</translation>
    </message>
    <message>
        <source>Learned from cuts: stable here with %1</source>
        <translation>Aus Schnitten gelernt: hier stabil mit %1</translation>
    </message>
    <message>
        <source>Judged cut: stable</source>
        <translation>Beurteilter Schnitt: stabil</translation>
    </message>
    <message>
        <source>Judged cut: chatter, %1</source>
        <translation>Beurteilter Schnitt: Rattern, %1</translation>
    </message>
    <message>
        <source>Judged cut: chatter</source>
        <translation>Beurteilter Schnitt: Rattern</translation>
    </message>
    <message>
        <source>No deeper: this cut is close to its limit</source>
        <translation>Nicht tiefer: dieser Schnitt liegt nahe an seiner Grenze</translation>
    </message>
    <message>
        <source>Depth could rise by about %1 (%2 to %3)</source>
        <translation>Die Zustellung könnte um etwa %1 steigen (%2 bis %3)</translation>
    </message>
</context>
<context>
    <name>LobeMarks</name>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>advised</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>what if</source>
        <translation>was wäre wenn</translation>
    </message>
    <message>
        <source>was stable</source>
        <translation>war stabil</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>Rattern</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Operate</source>
        <translation>Bedienen</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Tap test</source>
        <translation>Klopfen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
</context>
<context>
    <name>PlotFrame</name>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>Spectrogram of %1 [kHz]</source>
        <translation>Spektrogramm von %1 [kHz]</translation>
    </message>
    <message>
        <source>Vibration of %1, rms [%2]</source>
        <translation>Schwingung von %1, Effektivwert [%2]</translation>
    </message>
    <message>
        <source>Energy ratio, chatter to all</source>
        <translation>Energieanteil, Rattern zu allem</translation>
    </message>
    <message>
        <source>Spindle speed [rpm]</source>
        <translation>Drehzahl [1/min]</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>Auto</source>
        <translation>Automatik</translation>
    </message>
    <message>
        <source>Advise</source>
        <translation>Rat</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>the spindle speed is not known</source>
        <translation>die Drehzahl ist nicht bekannt</translation>
    </message>
    <message>
        <source>samples are missing ({0.0} counted)</source>
        <translation>es fehlen Abtastwerte ({0.0} gezählt)</translation>
    </message>
    <message>
        <source>the sensor is at its limit</source>
        <translation>der Sensor ist an seiner Grenze</translation>
    </message>
    <message>
        <source>channel {0.0} delivers values that are not numbers</source>
        <translation>Kanal {0.0} liefert Werte, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>channel {0.0} delivers a constant</source>
        <translation>Kanal {0.0} liefert einen festen Wert</translation>
    </message>
    <message>
        <source>the spindle is running up, {0.0} rpm</source>
        <translation>die Spindel läuft hoch, {0.0} 1/min</translation>
    </message>
    <message>
        <source>the tool is entering or leaving</source>
        <translation>das Werkzeug tritt ein oder aus</translation>
    </message>
    <message>
        <source>energy ratio {0.2} is over {1.2}</source>
        <translation>Energieanteil {0.2} liegt über {1.2}</translation>
    </message>
    <message>
        <source>energy ratio {0.3} grows above its floor of {1.3}</source>
        <translation>Energieanteil {0.3} wächst über seinen Grundwert {1.3}</translation>
    </message>
    <message>
        <source>a line at {2.1} Hz between the harmonics holds {0.3} of the vibration, over {1.3}</source>
        <translation>eine Linie bei {2.1} Hz zwischen den Harmonischen hält {0.3} der Schwingung, mehr als {1.3}</translation>
    </message>
    <message>
        <source>vibration that the harmonics leave, {0.3} of all, is over {1.3}, strongest at {2.1} Hz</source>
        <translation>was die Harmonischen übrig lassen, {0.3} von allem, liegt über {1.3}, am stärksten bei {2.1} Hz</translation>
    </message>
    <message>
        <source>coherence ratio {0.2} is over {1.2} at {2.1} Hz and its energy grows</source>
        <translation>Kohärenz {0.2} liegt über {1.2} bei {2.1} Hz, und ihre Energie wächst</translation>
    </message>
    <message>
        <source>coherence needs two channels, there are {0.0}</source>
        <translation>Kohärenz braucht zwei Kanäle, es gibt {0.0}</translation>
    </message>
    <message>
        <source>detector {0.0} failed</source>
        <translation>Detektor {0.0} ist ausgefallen</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>nichts zu tun</translation>
    </message>
    <message>
        <source>{0.0} rpm puts {1.0} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</source>
        <translation>{0.0} 1/min legt {1.0} Ratterwellen von {2.0} Hz zwischen zwei Zähne, bisher {3.0} 1/min</translation>
    </message>
    <message>
        <source>feed follows to {0.0} mm/min, so that each tooth still takes {1.3} mm</source>
        <translation>Vorschub folgt auf {0.0} mm/min, damit jeder Zahn weiter {1.3} mm nimmt</translation>
    </message>
    <message>
        <source>monitoring only</source>
        <translation>nur Überwachung</translation>
    </message>
    <message>
        <source>there is no usable verdict to act on</source>
        <translation>es gibt kein brauchbares Urteil, nach dem zu handeln wäre</translation>
    </message>
    <message>
        <source>going back towards {0.2}</source>
        <translation>geht zurück auf {0.2}</translation>
    </message>
    <message>
        <source>{0.0} rpm is already the speed for chatter at {1.0} Hz</source>
        <translation>{0.0} 1/min ist schon die Drehzahl gegen Rattern bei {1.0} Hz</translation>
    </message>
    <message>
        <source>{0.0} rpm with {1.0} waves between two teeth is in reach, {2.0} rpm is not (chatter {3.0} Hz)</source>
        <translation>{0.0} 1/min mit {1.0} Wellen zwischen zwei Zähnen ist erreichbar, {2.0} 1/min nicht (Rattern {3.0} Hz)</translation>
    </message>
    <message>
        <source>{0.0} rpm puts {1.2} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm</source>
        <translation>{0.0} 1/min legt {1.2} Ratterwellen von {2.0} Hz zwischen zwei Zähne, bisher {3.0} 1/min</translation>
    </message>
    <message>
        <source>{0.0} rpm brings a tooth harmonic closer to the chatter, {1.1} Hz apart, level {2.2} of its mean</source>
        <translation>{0.0} 1/min bringt eine Zahnharmonische näher ans Rattern, Abstand {1.1} Hz, Pegel {2.2} des Mittels</translation>
    </message>
    <message>
        <source>trying {0.0} rpm for less vibration, now {1.4}, best so far {2.4} at {3.0} rpm</source>
        <translation>versucht {0.0} 1/min für weniger Schwingung, jetzt {1.4}, bisher am besten {2.4} bei {3.0} 1/min</translation>
    </message>
    <message>
        <source>{0.0} rpm vibrates least, {1.4}</source>
        <translation>{0.0} 1/min schwingt am wenigsten, {1.4}</translation>
    </message>
    <message>
        <source>{0.0} rpm lies between the stability limits at {1.0} and {2.0} rpm (chatter {3.0} Hz)</source>
        <translation>{0.0} 1/min liegt zwischen den Stabilitätsgrenzen bei {1.0} und {2.0} 1/min (Rattern {3.0} Hz)</translation>
    </message>
    <message>
        <source>no speed in reach is stable at this depth, {1.2} mm at {2.0} rpm would be (chatter {3.0} Hz)</source>
        <translation>keine erreichbare Drehzahl ist in dieser Tiefe stabil, {1.2} mm bei {2.0} 1/min wären es (Rattern {3.0} Hz)</translation>
    </message>
    <message>
        <source>coherence {0.2} and energy {1.1} times that of the stable cut ask for {2.0} rpm and {3.0} mm/min</source>
        <translation>Kohärenz {0.2} und das {1.1}fache der Energie des stabilen Schnitts verlangen {2.0} 1/min und {3.0} mm/min</translation>
    </message>
    <message>
        <source>authority is off</source>
        <translation>die Befugnis ist aus</translation>
    </message>
    <message>
        <source>advice only</source>
        <translation>nur Rat</translation>
    </message>
    <message>
        <source>the request was not a number</source>
        <translation>die Anforderung war keine Zahl</translation>
    </message>
    <message>
        <source>asked for {0.0} %, the limits allow {1.0} %</source>
        <translation>verlangt {0.0} %, die Grenzen erlauben {1.0} %</translation>
    </message>
    <message>
        <source>the machine&apos;s state is {0.2} s old</source>
        <translation>der Maschinenzustand ist {0.2} s alt</translation>
    </message>
    <message>
        <source>the verdict is {0.2} s old</source>
        <translation>das Urteil ist {0.2} s alt</translation>
    </message>
    <message>
        <source>the machine is not running a program</source>
        <translation>die Maschine führt kein Programm aus</translation>
    </message>
    <message>
        <source>held by the operator</source>
        <translation>vom Bediener gehalten</translation>
    </message>
    <message>
        <source>waiting for the spindle, {0.0} of {1.0} rpm</source>
        <translation>wartet auf die Spindel, {0.0} von {1.0} 1/min</translation>
    </message>
    <message>
        <source>{0.0} changes in a minute, {1.0} allowed</source>
        <translation>{0.0} Änderungen in einer Minute, {1.0} erlaubt</translation>
    </message>
    <message>
        <source>the programmed values are back in force</source>
        <translation>die programmierten Werte gelten wieder</translation>
    </message>
    <message>
        <source>no fresh command for {0.2} s, programmed values restored</source>
        <translation>seit {0.2} s kein neuer Befehl, programmierte Werte wiederhergestellt</translation>
    </message>
    <message>
        <source>speed {0.1} % and feed {1.1} %, with the knobs {2.1} % and {3.1} %</source>
        <translation>Drehzahl {0.1} % und Vorschub {1.1} %, mit den Drehknöpfen {2.1} % und {3.1} %</translation>
    </message>
    <message>
        <source>speed {0.1} % on its way to {1.1} %, feed {2.1} % to {3.1} %</source>
        <translation>Drehzahl {0.1} % auf dem Weg zu {1.1} %, Vorschub {2.1} % zu {3.1} %</translation>
    </message>
    <message>
        <source>what the machine reports makes no sense</source>
        <translation>was die Maschine meldet, ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>the overrides have no effect: locked by the program, or at the machine&apos;s limit</source>
        <translation>die Overrides wirken nicht: vom Programm gesperrt, oder die Maschine ist an ihrer Grenze</translation>
    </message>
    <message>
        <source>something else controls the overrides</source>
        <translation>etwas anderes steuert die Overrides</translation>
    </message>
    <message>
        <source>the detector&apos;s verdict is not usable</source>
        <translation>das Urteil des Detektors ist nicht brauchbar</translation>
    </message>
    <message>
        <source>the request is {0.2} s old</source>
        <translation>die Anforderung ist {0.2} s alt</translation>
    </message>
    <message>
        <source>time stood still, jumped or went back</source>
        <translation>die Zeit stand still, sprang oder lief zurück</translation>
    </message>
    <message>
        <source>the tool is not in the cut</source>
        <translation>das Werkzeug ist nicht im Schnitt</translation>
    </message>
    <message>
        <source>the feed is on hold</source>
        <translation>der Vorschub ist angehalten</translation>
    </message>
    <message>
        <source>the operator turns the knobs: speed {0.0} %, feed {1.0} %</source>
        <translation>der Bediener dreht die Knöpfe: Drehzahl {0.0} %, Vorschub {1.0} %</translation>
    </message>
    <message>
        <source>the spindle does not follow, {0.0} instead of {1.0} rpm</source>
        <translation>die Spindel folgt nicht, {0.0} statt {1.0} 1/min</translation>
    </message>
    <message>
        <source>the machine does not take the override, {0.1} % instead of {1.1} %</source>
        <translation>die Maschine nimmt den Override nicht an, {0.1} % statt {1.1} %</translation>
    </message>
    <message>
        <source>the program went from {0.0} to {1.0} rpm, starting again from 100 %</source>
        <translation>das Programm ging von {0.0} auf {1.0} 1/min, beginnt wieder bei 100 %</translation>
    </message>
    <message>
        <source>waiting {0.1} s before taking the overrides again</source>
        <translation>wartet {0.1} s, bevor es die Overrides wieder übernimmt</translation>
    </message>
    <message>
        <source>too many changes, waiting {0.0} s</source>
        <translation>zu viele Änderungen, wartet {0.0} s</translation>
    </message>
    <message>
        <source>Auto is not allowed in this set-up</source>
        <translation>Automatik ist in dieser Einrichtung nicht erlaubt</translation>
    </message>
    <message>
        <source>more than {0.0} changes in a minute again, advice only from now on</source>
        <translation>wieder mehr als {0.0} Änderungen in einer Minute, ab jetzt nur noch Rat</translation>
    </message>
    <message>
        <source>the operator accepted {0.0} rpm and {1.0} mm/min</source>
        <translation>der Bediener hat {0.0} 1/min und {1.0} mm/min angenommen</translation>
    </message>
    <message>
        <source>the operator refused {0.0} rpm and {1.0} mm/min</source>
        <translation>der Bediener hat {0.0} 1/min und {1.0} mm/min abgelehnt</translation>
    </message>
    <message>
        <source>chatter at {0.0} Hz, energy ratio {1.2}</source>
        <translation>Rattern bei {0.0} Hz, Energieanteil {1.2}</translation>
    </message>
    <message>
        <source>authority changed from {0.0} to {1.0}</source>
        <translation>Befugnis von {0.0} auf {1.0} geändert</translation>
    </message>
    <message>
        <source>back to 100 % at the operator&apos;s request</source>
        <translation>auf Wunsch des Bedieners zurück auf 100 %</translation>
    </message>
    <message>
        <source>the machine has not answered for {0.2} s</source>
        <translation>die Maschine antwortet seit {0.2} s nicht</translation>
    </message>
    <message>
        <source>the machine answers again</source>
        <translation>die Maschine antwortet wieder</translation>
    </message>
    <message>
        <source>recording has stopped</source>
        <translation>die Aufzeichnung hat angehalten</translation>
    </message>
    <message>
        <source>{0.0} blocks were dropped</source>
        <translation>{0.0} Blöcke gingen verloren</translation>
    </message>
    <message>
        <source>Auto is granted because this machine is simulated</source>
        <translation>Automatik ist erlaubt, weil diese Maschine simuliert ist</translation>
    </message>
    <message>
        <source>the strategy failed, monitoring only from now on</source>
        <translation>die Strategie ist ausgefallen, ab jetzt nur Überwachung</translation>
    </message>
    <message>
        <source>the advice has changed to {0.0} rpm and {1.0} mm/min, it needs another touch</source>
        <translation>der Rat ist jetzt {0.0} 1/min und {1.0} mm/min, er muss noch einmal berührt werden</translation>
    </message>
    <message>
        <source>the tool left the cut after {0.2} s and {1.1} mm of feed in chatter</source>
        <translation>das Werkzeug verließ den Schnitt nach {0.2} s und {1.1} mm Vorschub im Rattern</translation>
    </message>
    <message>
        <source>the machine or its program put the override back to {0.0} %, Stillcut had it at {1.0} %</source>
        <translation>die Maschine oder ihr Programm hat den Override auf {0.0} % zurückgesetzt, Stillcut hatte {1.0} % eingestellt</translation>
    </message>
    <message>
        <source>{0.0} lines more than there was room for, the most important were kept</source>
        <translation>{0.0} Zeilen mehr als Platz war, die wichtigsten sind erhalten</translation>
    </message>
    <message>
        <source>channel {0.0} fell silent in the middle of the cut, look for a broken cable</source>
        <translation>Kanal {0.0} verstummte mitten im Schnitt, nach einem Kabelbruch sehen</translation>
    </message>
    <message>
        <source>channel {0.0} knocks at any spindle angle, its sensor is loose</source>
        <translation>Kanal {0.0} schlägt bei beliebigem Spindelwinkel, sein Sensor ist lose</translation>
    </message>
    <message>
        <source>channel {0.0} has left its zero and stands at {1.1}, look at its supply and range</source>
        <translation>Kanal {0.0} hat seinen Nullpunkt verlassen und steht bei {1.1}, nach Speisung und Messbereich sehen</translation>
    </message>
    <message>
        <source>most of what channel {0.0} delivers is mains hum of {1.0} Hz, look at its shield and ground</source>
        <translation>das meiste, was Kanal {0.0} liefert, ist Netzbrummen von {1.0} Hz, nach Schirm und Masse sehen</translation>
    </message>
    <message>
        <source>channel {0.0} delivers strong noise and no cut</source>
        <translation>Kanal {0.0} liefert lautes Rauschen und nichts von einem Schnitt</translation>
    </message>
    <message>
        <source>channels {0.0} and {1.0} claim two axes and deliver the same, one of them is wired or named wrongly</source>
        <translation>die Kanäle {0.0} und {1.0} nennen zwei Achsen und liefern dasselbe, einer ist falsch verdrahtet oder benannt</translation>
    </message>
    <message>
        <source>the device delivers {0.1} samples a second instead of {1.1}</source>
        <translation>das Gerät liefert {0.1} Werte in der Sekunde statt {1.1}</translation>
    </message>
    <message>
        <source>channel {0.0} has a line at {1.1} Hz that moves as order {2.0} folded back, its anti-alias filter is missing</source>
        <translation>Kanal {0.0} zeigt bei {1.1} Hz eine Linie, die sich wie die zurückgefaltete Ordnung {2.0} bewegt, sein Antialiasing-Filter fehlt</translation>
    </message>
    <message>
        <source>still learning, {0.1} s to go</source>
        <translation>lernt noch, {0.1} s fehlen</translation>
    </message>
    <message>
        <source>channel {0.0} repeats its values, or comes at another rate than set</source>
        <translation>Kanal {0.0} wiederholt Werte oder kommt mit anderer Rate als angegeben</translation>
    </message>
    <message>
        <source>{0.0} rpm would help against chatter of {3.0} Hz but the override reaches {1.0} to {2.0} rpm</source>
        <translation>{0.0} 1/min würden gegen Rattern mit {3.0} Hz helfen, doch der Override reicht von {1.0} bis {2.0} 1/min</translation>
    </message>
    <message>
        <source>monitoring only, at {0.0} rpm and an energy ratio of {1.2}</source>
        <translation>nur Überwachung, bei {0.0} 1/min und einem Energieanteil von {1.2}</translation>
    </message>
    <message>
        <source>nothing to do at {0.0} rpm and an energy ratio of {1.2}</source>
        <translation>nichts zu tun bei {0.0} 1/min und einem Energieanteil von {1.2}</translation>
    </message>
    <message>
        <source>verdict or machine state cannot be acted on, staying at {0.0} rpm</source>
        <translation>nach Urteil oder Maschinenzustand lässt sich nicht handeln, bleibt bei {0.0} 1/min</translation>
    </message>
    <message>
        <source>a tone of {0.0} Hz fills the signal from its start, chatter or the machine itself</source>
        <translation>ein Ton von {0.0} Hz füllt das Signal von Anfang an, Rattern oder die Maschine selbst</translation>
    </message>
    <message>
        <source>the move to {0.0} rpm did not help ({1.0} in a row, {2.0} end Auto)</source>
        <translation>der Wechsel auf {0.0} 1/min hat nicht geholfen ({1.0} hintereinander, {2.0} beenden Auto)</translation>
    </message>
    <message>
        <source>at {0.0} rpm the cut is {1.1} times as loud as before the move ({2.0} moves in a row without help, {3.0} end Auto)</source>
        <translation>bei {0.0} 1/min ist der Schnitt {1.1}-mal so laut wie vor dem Wechsel ({2.0} Wechsel hintereinander ohne Hilfe, {3.0} beenden Auto)</translation>
    </message>
    <message>
        <source>{0.0} rpm made the cut louder and is not tried again</source>
        <translation>{0.0} 1/min hat den Schnitt lauter gemacht und wird nicht noch einmal versucht</translation>
    </message>
    <message>
        <source>{0.0} moves in a row did not help, advice only from now on</source>
        <translation>{0.0} Wechsel hintereinander haben nicht geholfen, von jetzt an nur Rat</translation>
    </message>
    <message>
        <source>no chatter at {0.0} rpm, though the cut is {1.1} times as loud as before the move</source>
        <translation>kein Rattern bei {0.0} 1/min, aber der Schnitt ist {1.1}-mal so laut wie vor dem Wechsel</translation>
    </message>
    <message>
        <source>the newest samples that were judged are {0.2} s old, nothing is moved by them</source>
        <translation>die neuesten beurteilten Messwerte sind {0.2} s alt, nach ihnen wird nichts bewegt</translation>
    </message>
    <message>
        <source>channel {0.0} delivers values that no sensor has</source>
        <translation>Kanal {0.0} liefert Werte, die kein Sensor hat</translation>
    </message>
    <message>
        <source>the number of flutes is not known</source>
        <translation>die Schneidenzahl ist nicht bekannt</translation>
    </message>
    <message>
        <source>stable, keeping {0.0} rpm that chatter of {1.0} Hz asked for</source>
        <translation>stabil, bleibt bei {0.0} 1/min, die das Rattern mit {1.0} Hz verlangt hat</translation>
    </message>
    <message>
        <source>{0.0} speeds tried and none is stable (chatter {1.0} Hz): take less depth than where it began, {2.0} mm of feed before</source>
        <translation>{0.0} Drehzahlen versucht, keine ist stabil (Rattern {1.0} Hz): weniger Zustellung nehmen als dort, wo es begann, {2.0} mm Vorschub zuvor</translation>
    </message>
    <message>
        <source>stable again after {0.2} s and {1.1} mm of feed</source>
        <translation>nach {0.2} s und {1.1} mm Vorschub wieder stabil</translation>
    </message>
    <message>
        <source>the number of flutes is not known, no speed follows from chatter of {0.0} Hz at {1.0} rpm</source>
        <translation>die Schneidenzahl ist nicht bekannt, aus Rattern mit {0.0} Hz bei {1.0} 1/min folgt keine Drehzahl</translation>
    </message>
    <message>
        <source>nothing was read from a machine yet</source>
        <translation>von einer Maschine wurde noch nichts gelesen</translation>
    </message>
    <message>
        <source>the tone of an axis drive glides, now at {0.0} Hz</source>
        <translation>der Ton eines Achsantriebs gleitet, jetzt bei {0.0} Hz</translation>
    </message>
</context>
<context>
    <name>ReportPages</name>
    <message>
        <source>Cut report</source>
        <translation>Schnittbericht</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Alarms and what was done</source>
        <translation>Alarme und was getan wurde</translation>
    </message>
    <message>
        <source>Before: highest until the first command. After: newest at the end of the alarm. Numbers are those in the plots.</source>
        <translation>Vorher: höchster Wert bis zum ersten Befehl. Nachher: neuester am Ende des Alarms. Die Nummern sind die in den Bildern.</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Sensor check</source>
        <translation>Sensorprüfung</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Settings changed during the cut</source>
        <translation>Während des Schnitts geändert</translation>
    </message>
    <message>
        <source>Settings at the beginning</source>
        <translation>Einstellungen zu Beginn</translation>
    </message>
</context>
<context>
    <name>Session</name>
    <message>
        <source>The device is gone; identify again when it is back</source>
        <translation>Das Gerät ist weg; wenn es wieder da ist, neu identifizieren</translation>
    </message>
    <message>
        <source>Replay: %1</source>
        <translation>Wiedergabe: %1</translation>
    </message>
    <message>
        <source>The run has ended</source>
        <translation>Der Lauf ist zu Ende</translation>
    </message>
    <message>
        <source>The run of %1 did not end in order; nothing of it was recorded</source>
        <translation>Der Lauf vom %1 endete nicht ordentlich; von ihm ist nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>The run of %1 did not end in order; it is recorded in %2</source>
        <translation>Der Lauf vom %1 endete nicht ordentlich; er ist aufgezeichnet in %2</translation>
    </message>
</context>
<context>
    <name>Tap</name>
    <message>
        <source>tap test: %1 modes</source>
        <translation>Klopfversuch: %1 Moden</translation>
    </message>
    <message>
        <source>Simulated hammer and tool</source>
        <translation>Simulierter Hammer und Werkzeug</translation>
    </message>
    <message>
        <source>As chosen under Set up</source>
        <translation>Wie unter Aufbau gewählt</translation>
    </message>
    <message>
        <source>Say it below and touch READ.</source>
        <translation>Unten angeben und LESEN berühren.</translation>
    </message>
    <message>
        <source>The resonance at %1 Hz is deeper than every mode found, and too noisy to be fitted: a depth would be too large. Hit harder, average more hits, or take a harder tip.</source>
        <translation>Die Resonanz bei %1 Hz ist nachgiebiger als jede gefundene Mode und zu verrauscht, um angepasst zu werden: eine Zustellung wäre zu groß. Kräftiger schlagen, über mehr Schläge mitteln oder eine härtere Spitze nehmen.</translation>
    </message>
</context>
<context>
    <name>Trial</name>
    <message>
        <source>%1 Hz, channels: %2</source>
        <translation>%1 Hz, Kanäle: %2</translation>
    </message>
    <message>
        <source>%1: a tone of %2 Hz, %3 % of what is heard; scale %4 ± %5 %6</source>
        <translation>%1: ein Ton von %2 Hz, %3 % des Gehörten; Faktor %4 ± %5 %6</translation>
    </message>
</context>
<context>
    <name>stillcut::ui</name>
    <message>
        <source>%1 rpm, %2</source>
        <translation>%1 1/min, %2</translation>
    </message>
    <message>
        <source>Costs no time</source>
        <translation>Kostet keine Zeit</translation>
    </message>
    <message>
        <source>Costs %1 time</source>
        <translation>Kostet %1 Zeit</translation>
    </message>
    <message>
        <source>Saves %1 time</source>
        <translation>Spart %1 Zeit</translation>
    </message>
    <message>
        <source>cutting speed %1</source>
        <translation>Schnittgeschwindigkeit %1</translation>
    </message>
    <message>
        <source>The feed stays as it is</source>
        <translation>Der Vorschub bleibt, wie er ist</translation>
    </message>
    <message>
        <source>Feed follows: %1</source>
        <translation>Vorschub folgt: %1</translation>
    </message>
    <message>
        <source>The speed stays as it is</source>
        <translation>Die Drehzahl bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>ADVICE</source>
        <translation>RAT</translation>
    </message>
    <message>
        <source>Back to 100 %</source>
        <translation>Zurück auf 100 %</translation>
    </message>
    <message>
        <source>ASKED FOR, NOT CONFIRMED BY THE MACHINE</source>
        <translation>VERLANGT, VON DER MASCHINE NICHT BESTÄTIGT</translation>
    </message>
    <message>
        <source>WHAT TO DO</source>
        <translation>WAS ZU TUN IST</translation>
    </message>
    <message>
        <source>No advice</source>
        <translation>Kein Rat</translation>
    </message>
    <message>
        <source>There is no live picture to advise on</source>
        <translation>Ohne aktuelles Bild kein Rat</translation>
    </message>
    <message>
        <source>Nothing to do</source>
        <translation>Nichts zu tun</translation>
    </message>
    <message>
        <source>Authority is off: Stillcut only watches</source>
        <translation>Befugnis aus: Stillcut schaut nur zu</translation>
    </message>
    <message>
        <source>There is no verdict to act on</source>
        <translation>Es gibt kein Urteil zum Handeln</translation>
    </message>
    <message>
        <source>The strategy has not decided yet</source>
        <translation>Die Strategie hat noch nicht entschieden</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>The machine does not answer; last values %1 old</source>
        <translation>Die Maschine antwortet nicht; letzte Werte %1 alt</translation>
    </message>
    <message>
        <source>Values are %1 old</source>
        <translation>Werte sind %1 alt</translation>
    </message>
    <message>
        <source>Another program has the overrides</source>
        <translation>Ein anderes Programm hat die Overrides</translation>
    </message>
    <message>
        <source>The program has switched overrides off</source>
        <translation>Das Programm hat Overrides abgeschaltet</translation>
    </message>
    <message>
        <source>Feed hold</source>
        <translation>Vorschub angehalten</translation>
    </message>
    <message>
        <source>Energy ratio</source>
        <translation>Energieanteil</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Schwingung</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Nothing was read from the machine yet</source>
        <translation>Noch nichts von der Maschine gelesen</translation>
    </message>
    <message>
        <source>Knobs %1, %2</source>
        <translation>Knöpfe %1, %2</translation>
    </message>
    <message>
        <source>Knobs %1, %2; feed per tooth %3</source>
        <translation>Knöpfe %1, %2; Vorschub je Zahn %3</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>no answer for %1</source>
        <translation>seit %1 keine Antwort</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>no samples yet</source>
        <translation>noch keine Werte</translation>
    </message>
    <message>
        <source>nothing for %1</source>
        <translation>seit %1 nichts</translation>
    </message>
    <message>
        <source>at its limit</source>
        <translation>an der Grenze</translation>
    </message>
    <message>
        <source>dead</source>
        <translation>tot</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>samples missing</source>
        <translation>Werte fehlen</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1, %2 lost</source>
        <translation>%1, %2 verloren</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>Chatter %1</source>
        <translation>Rattern %1</translation>
    </message>
    <message>
        <source>%1, acting</source>
        <translation>%1, greift ein</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>Rattern %1</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>You are in command</source>
        <translation>Sie haben das Kommando</translation>
    </message>
    <message>
        <source>Stillcut is in command</source>
        <translation>Stillcut hat das Kommando</translation>
    </message>
    <message>
        <source>You are in command, Stillcut advises</source>
        <translation>Sie haben das Kommando, Stillcut rät</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>%1, on this simulated machine</source>
        <translation>%1, auf dieser simulierten Maschine</translation>
    </message>
    <message>
        <source>as last heard, %1 ago</source>
        <translation>nach letztem Stand, vor %1</translation>
    </message>
    <message>
        <source>held by you, %1</source>
        <translation>von Ihnen gehalten, %1</translation>
    </message>
    <message>
        <source>NO CUT</source>
        <translation>LUFT</translation>
    </message>
    <message>
        <source>STABLE</source>
        <translation>STABIL</translation>
    </message>
    <message>
        <source>ONSET</source>
        <translation>BEGINN</translation>
    </message>
    <message>
        <source>CHATTER</source>
        <translation>RATTERN</translation>
    </message>
    <message>
        <source>period doubling</source>
        <translation>doppelte Periode</translation>
    </message>
    <message>
        <source>forced vibration</source>
        <translation>fremderregt</translation>
    </message>
    <message>
        <source>growing</source>
        <translation>wachsend</translation>
    </message>
    <message>
        <source>steady</source>
        <translation>gleichbleibend</translation>
    </message>
    <message>
        <source>dying down</source>
        <translation>abklingend</translation>
    </message>
    <message>
        <source>The tool is in the air</source>
        <translation>Das Werkzeug ist in der Luft</translation>
    </message>
    <message>
        <source>The spindle is running up</source>
        <translation>Die Spindel läuft hoch</translation>
    </message>
    <message>
        <source>The tool is entering</source>
        <translation>Das Werkzeug tritt ein</translation>
    </message>
    <message>
        <source>The tool is leaving</source>
        <translation>Das Werkzeug tritt aus</translation>
    </message>
    <message>
        <source>No chatter in this run</source>
        <translation>Kein Rattern in diesem Lauf</translation>
    </message>
    <message>
        <source>In chatter so far: %1, %2</source>
        <translation>Bisher im Rattern: %1, %2</translation>
    </message>
    <message>
        <source>ENTRY</source>
        <translation>EINTRITT</translation>
    </message>
    <message>
        <source>EXIT</source>
        <translation>AUSTRITT</translation>
    </message>
    <message>
        <source>NO VERDICT</source>
        <translation>KEIN URTEIL</translation>
    </message>
    <message>
        <source>The picture is stale: nothing new for %1</source>
        <translation>Das Bild ist veraltet: seit %1 nichts Neues</translation>
    </message>
    <message>
        <source>Last verdict: %1 %2</source>
        <translation>Letztes Urteil: %1 %2</translation>
    </message>
    <message>
        <source>For %1</source>
        <translation>Seit %1</translation>
    </message>
    <message>
        <source>For %1, %2 of feed</source>
        <translation>Seit %1, %2 Vorschubweg</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>Wartet auf die ersten Messwerte</translation>
    </message>
    <message>
        <source>The run has ended</source>
        <translation>Der Lauf ist zu Ende</translation>
    </message>
    <message>
        <source>The detector gives no reason</source>
        <translation>Der Detektor nennt keinen Grund</translation>
    </message>
    <message>
        <source>Early warning: vibration begins to grow</source>
        <translation>Frühwarnung: die Schwingung beginnt zu wachsen</translation>
    </message>
    <message>
        <source>The tool does not cut</source>
        <translation>Das Werkzeug schneidet nicht</translation>
    </message>
    <message>
        <source>Auto: Stillcut commanded the overrides</source>
        <translation>Automatik: Stillcut steuerte die Overrides</translation>
    </message>
    <message>
        <source>Advise: Stillcut proposed</source>
        <translation>Rat: Stillcut schlug vor</translation>
    </message>
    <message>
        <source>Off: Stillcut watched</source>
        <translation>Aus: Stillcut sah zu</translation>
    </message>
    <message>
        <source>no signal: check cable and supply</source>
        <translation>kein Signal: Kabel und Versorgung prüfen</translation>
    </message>
    <message>
        <source>clipped: lower the gain</source>
        <translation>übersteuert: Verstärkung senken</translation>
    </message>
    <message>
        <source>large constant part: check coupling</source>
        <translation>großer Gleichanteil: Kopplung prüfen</translation>
    </message>
    <message>
        <source>far weaker than the others: loose?</source>
        <translation>viel schwächer als die anderen: locker?</translation>
    </message>
    <message>
        <source>in order</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>cut ended</source>
        <translation>Schnitt zu Ende</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>nicht beantwortet</translation>
    </message>
    <message>
        <source> (simulated)</source>
        <translation> (simuliert)</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>, diameter </source>
        <translation>, Durchmesser </translation>
    </message>
    <message>
        <source>Programmed</source>
        <translation>Programmiert</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>Befugnis</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>%1 at %2 Hz</source>
        <translation>%1 mit %2 Hz</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlend</translation>
    </message>
    <message>
        <source>%1 in %2 gaps</source>
        <translation>%1 in %2 Lücken</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>not closed: ends where it was cut off</source>
        <translation>nicht geschlossen: endet, wo sie abbrach</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Aufgezeichnet von</translation>
    </message>
    <message>
        <source>This recording holds measurements only: nobody decided while it was made. Vibration and spectrogram are shown as they are.</source>
        <translation>Diese Aufzeichnung enthält nur Messwerte: währenddessen wurde nichts entschieden. Schwingung und Spektrogramm sind gezeigt, wie sie sind.</translation>
    </message>
    <message>
        <source>No chatter was found.</source>
        <translation>Es wurde kein Rattern gefunden.</translation>
    </message>
    <message>
        <source>Chatter began once</source>
        <translation>Rattern begann einmal</translation>
    </message>
    <message>
        <source>Chatter began %1 times</source>
        <translation>Rattern begann %1-mal</translation>
    </message>
    <message>
        <source>, first at %1</source>
        <translation>, zuerst bei %1</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>; it lasted %1 in all</source>
        <translation>; es dauerte insgesamt %1</translation>
    </message>
    <message>
        <source> and marked %1 of path</source>
        <translation> und zeichnete %1 Weg</translation>
    </message>
    <message>
        <source>The overrides were not touched.</source>
        <translation>Die Overrides wurden nicht berührt.</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>Chatter</source>
        <translation>Rattern</translation>
    </message>
    <message>
        <source>Vibration rms</source>
        <translation>Schwingung eff.</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>eff.</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source> (assumed)</source>
        <translation> (angenommen)</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>info</source>
        <translation>Info</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stabil</translation>
    </message>
    <message>
        <source>onset</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>Rattern</translation>
    </message>
    <message>
        <source>Stillcut moved speed or feed</source>
        <translation>Stillcut änderte Drehzahl oder Vorschub</translation>
    </message>
    <message>
        <source>uncalibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>too short for a spectrogram</source>
        <translation>zu kurz für ein Spektrogramm</translation>
    </message>
    <message>
        <source>Not computed here</source>
        <translation>Hier nicht berechnet</translation>
    </message>
    <message>
        <source>The diagram does not reach this speed</source>
        <translation>Das Diagramm reicht nicht bis zu dieser Drehzahl</translation>
    </message>
    <message>
        <source>Compute the diagram first</source>
        <translation>Erst das Diagramm berechnen</translation>
    </message>
    <message>
        <source>STABLE, %1 deeper would be too deep</source>
        <translation>STABIL, %1 tiefer wäre zu tief</translation>
    </message>
    <message>
        <source>CHATTER, %1 too deep</source>
        <translation>RATTERN, %1 zu tief</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>Grenze %1</translation>
    </message>
    <message>
        <source>removes %1</source>
        <translation>Abtrag %1</translation>
    </message>
    <message>
        <source>%1 more time</source>
        <translation>%1 mehr Zeit</translation>
    </message>
    <message>
        <source>%1 less time</source>
        <translation>%1 weniger Zeit</translation>
    </message>
    <message>
        <source>, order %1</source>
        <translation>, Ordnung %1</translation>
    </message>
    <message>
        <source>fell silent</source>
        <translation>verstummt</translation>
    </message>
    <message>
        <source>loose</source>
        <translation>lose</translation>
    </message>
    <message>
        <source>left its zero</source>
        <translation>Nullpunkt verlassen</translation>
    </message>
    <message>
        <source>mains hum</source>
        <translation>Netzbrummen</translation>
    </message>
    <message>
        <source>only noise</source>
        <translation>nur Rauschen</translation>
    </message>
    <message>
        <source>one axis twice</source>
        <translation>eine Achse doppelt</translation>
    </message>
    <message>
        <source>wrong rate</source>
        <translation>falsche Rate</translation>
    </message>
    <message>
        <source>not tried yet</source>
        <translation>noch nicht versucht</translation>
    </message>
    <message>
        <source>no cut</source>
        <translation>kein Schnitt</translation>
    </message>
    <message>
        <source>energy ratio</source>
        <translation>Energieanteil</translation>
    </message>
    <message>
        <source>frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>changes from turn to turn</source>
        <translation>Änderung von Umdrehung zu Umdrehung</translation>
    </message>
    <message>
        <source>learned noise floor</source>
        <translation>gelernter Rauschpegel</translation>
    </message>
    <message>
        <source>evidence of growth</source>
        <translation>Beleg für Wachstum</translation>
    </message>
    <message>
        <source>purity of the line</source>
        <translation>Reinheit der Linie</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>vibration energy</source>
        <translation>Schwingungsenergie</translation>
    </message>
    <message>
        <source>warned ahead by [s]</source>
        <translation>Vorwarnzeit [s]</translation>
    </message>
    <message>
        <source>noise variance</source>
        <translation>Rauschvarianz</translation>
    </message>
    <message>
        <source>perturbation power</source>
        <translation>Störleistung</translation>
    </message>
    <message>
        <source>largest root</source>
        <translation>größte Wurzel</translation>
    </message>
    <message>
        <source>part outside the harmonics</source>
        <translation>Anteil außerhalb der Harmonischen</translation>
    </message>
    <message>
        <source>highest line</source>
        <translation>höchste Linie</translation>
    </message>
    <message>
        <source>before every detector</source>
        <translation>vor jedem Detektor</translation>
    </message>
    <message>
        <source>detector</source>
        <translation>Detektor</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>limits of the machine</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>in charge</source>
        <translation>führt</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>does not run</source>
        <translation>läuft nicht</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>true alarm</source>
        <translation>echter Alarm</translation>
    </message>
    <message>
        <source>false alarm</source>
        <translation>Fehlalarm</translation>
    </message>
    <message>
        <source>heard</source>
        <translation>gehört</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>%1: found %2 of %3, false %4 (%5 per hour), delay %6</source>
        <translation>%1: gefunden %2 von %3, falsch %4 (%5 je Stunde), Verzug %6</translation>
    </message>
    <message>
        <source>Every detector runs on it: %1</source>
        <translation>Jeder Detektor läuft darüber: %1</translation>
    </message>
    <message>
        <source>Every detector has run on it</source>
        <translation>Jeder Detektor ist darüber gelaufen</translation>
    </message>
    <message>
        <source>Scoring: %1</source>
        <translation>Bewertung: %1</translation>
    </message>
    <message>
        <source>Scored against what is marked</source>
        <translation>Gegen die Markierungen bewertet</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Schreibe %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>aliased</source>
        <translation>gefaltet</translation>
    </message>
    <message>
        <source>%1 old, acts in %2</source>
        <translation>%1 alt, wirkt nach %2</translation>
    </message>
    <message>
        <source>No model of this path: identify it, with the tool out of the cut</source>
        <translation>Kein Modell dieser Strecke: ermitteln, mit dem Werkzeug außer Eingriff</translation>
    </message>
    <message>
        <source>Model: leaves %1 unexplained, %2 of 90° phase error left, worst at %3</source>
        <translation>Modell: %1 bleiben unerklärt, %2 von 90° Phasenfehler übrig, am schlechtesten bei %3</translation>
    </message>
    <message>
        <source>Loop delay %1, may grow by %2; identified %3 ago</source>
        <translation>Verzug der Schleife %1, darf um %2 wachsen; ermittelt vor %3</translation>
    </message>
    <message>
        <source>It promises no stable control: identify anew</source>
        <translation>Es verspricht keine stabile Regelung: neu ermitteln</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>beginnt</translation>
    </message>
    <message>
        <source>let go: %1</source>
        <translation>losgelassen: %1</translation>
    </message>
    <message>
        <source>released</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>nobody renewed the lease</source>
        <translation>niemand hat die Frist erneuert</translation>
    </message>
    <message>
        <source>a value was not finite</source>
        <translation>ein Wert war nicht endlich</translation>
    </message>
    <message>
        <source>the loop diverged</source>
        <translation>die Schleife lief davon</translation>
    </message>
    <message>
        <source>the actuator was at its end and the vibration grew</source>
        <translation>der Aktor war am Anschlag und die Schwingung wuchs</translation>
    </message>
    <message>
        <source>control made the vibration worse</source>
        <translation>die Regelung machte die Schwingung schlimmer</translation>
    </message>
    <message>
        <source>the error sensor stands still</source>
        <translation>der Fehlersensor steht still</translation>
    </message>
    <message>
        <source>the device lost a block</source>
        <translation>das Gerät hat einen Block verloren</translation>
    </message>
    <message>
        <source>stroke %1, at its end for %2 of the time</source>
        <translation>Hub %1, zu %2 der Zeit am Anschlag</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>Hub %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: does not run</source>
        <translation>%1: läuft nicht</translation>
    </message>
    <message>
        <source>Identifying the paths: %1</source>
        <translation>Die Strecken werden ermittelt: %1</translation>
    </message>
    <message>
        <source>%1: %2, blocks of %3, worst block %4</source>
        <translation>%1: %2, Blöcke zu %3, längster Block %4</translation>
    </message>
    <message>
        <source>%1, %2 blocks late</source>
        <translation>%1, %2 Blöcke zu spät</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>STABLE, on an island above the limit: less depth would chatter</source>
        <translation>STABIL, auf einer Insel über der Grenze: weniger Tiefe würde rattern</translation>
    </message>
    <message>
        <source>%1 told, not measured yet</source>
        <translation>%1 angegeben, noch nicht gemessen</translation>
    </message>
    <message>
        <source>%1 told, %2 measured</source>
        <translation>%1 angegeben, %2 gemessen</translation>
    </message>
    <message>
        <source>%1, %2 samples lost</source>
        <translation>%1, %2 Abtastwerte verloren</translation>
    </message>
    <message>
        <source>No samples come</source>
        <translation>Es kommen keine Abtastwerte</translation>
    </message>
    <message>
        <source>%1: %2, peak %3</source>
        <translation>%1: %2, Spitze %3</translation>
    </message>
    <message>
        <source>All sensors in order</source>
        <translation>Alle Sensoren in Ordnung</translation>
    </message>
    <message>
        <source>Sensor in order: %1</source>
        <translation>Sensor in Ordnung: %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>kein Mal</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>%1, none marked false</source>
        <translation>%1, keiner davon als falsch markiert</translation>
    </message>
    <message>
        <source>%1, %2 of them marked false</source>
        <translation>%1, davon %2 als falsch markiert</translation>
    </message>
    <message>
        <source>%1 alarmed %2</source>
        <translation>%1 hat Alarm gegeben: %2</translation>
    </message>
    <message>
        <source>%1 would have alarmed %2; as recorded: %3</source>
        <translation>%1 hätte Alarm gegeben: %2; wie aufgezeichnet: %3</translation>
    </message>
    <message>
        <source>a loop of its own</source>
        <translation>ein eigener Regelkreis</translation>
    </message>
    <message>
        <source>Joined device, %1 channels: %2 by this computer&apos;s clock, times steady within %3 µs, beside any constant delay of its wire</source>
        <translation>Weiteres Gerät, %1 Kanäle: %2 nach der Uhr dieses Rechners, Zeiten auf %3 µs gleichmäßig, ohne eine feste Verzögerung seiner Leitung</translation>
    </message>
    <message>
        <source>No program runs, or the machine is off</source>
        <translation>Kein Programm läuft, oder die Maschine ist aus</translation>
    </message>
    <message>
        <source>Reading %1: %2</source>
        <translation>%1 wird gelesen: %2</translation>
    </message>
    <message>
        <source>time +%1</source>
        <translation>Zeit +%1</translation>
    </message>
    <message>
        <source>at the next event</source>
        <translation>beim nächsten Ereignis</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>Marked as</source>
        <translation>Markiert als</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Set to</source>
        <translation>Gesetzt auf</translation>
    </message>
    <message>
        <source>one this program does not know</source>
        <translation>einer, den dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>The machine is off</source>
        <translation>Die Maschine ist aus</translation>
    </message>
    <message>
        <source>The machine is off at speed %1, feed %2; Stillcut brings them back when it is on</source>
        <translation>Die Maschine ist aus bei Drehzahl %1, Vorschub %2; Stillcut nimmt beides zurück, wenn sie an ist</translation>
    </message>
    <message>
        <source>The machine is in alarm</source>
        <translation>Die Maschine meldet Alarm</translation>
    </message>
    <message>
        <source>No program runs</source>
        <translation>Kein Programm läuft</translation>
    </message>
    <message>
        <source>The program has locked both overrides (M49)</source>
        <translation>Das Programm hat beide Override gesperrt (M49)</translation>
    </message>
    <message>
        <source>The spindle override has no effect: locked by the program (M51, M49), or the machine is at its limit</source>
        <translation>Der Spindel-Override wirkt nicht: vom Programm gesperrt (M51, M49), oder die Maschine ist an ihrer Grenze</translation>
    </message>
    <message>
        <source>The feed override has no effect: locked by the program (M50, M49), or the machine is at its limit</source>
        <translation>Der Vorschub-Override wirkt nicht: vom Programm gesperrt (M50, M49), oder die Maschine ist an ihrer Grenze</translation>
    </message>
    <message>
        <source>Adaptive feed has no effect: the program has not said M52 P1</source>
        <translation>Der adaptive Vorschub wirkt nicht: im Programm fehlt M52 P1</translation>
    </message>
    <message>
        <source>LinuxCNC refuses control: is the control password right?</source>
        <translation>LinuxCNC verweigert die Kontrolle: Stimmt das Kontroll-Passwort?</translation>
    </message>
    <message>
        <source>stillcut-hal does not answer</source>
        <translation>stillcut-hal antwortet nicht</translation>
    </message>
    <message>
        <source>stillcut-hal has not seen the machine&apos;s watchdog act</source>
        <translation>stillcut-hal hat den Watchdog der Maschine nicht auslösen sehen</translation>
    </message>
    <message>
        <source>The machine&apos;s watchdog or the operator&apos;s switch has taken Stillcut out</source>
        <translation>Der Watchdog der Maschine oder der Schalter des Bedieners hat Stillcut herausgenommen</translation>
    </message>
    <message>
        <source>identifying, %1</source>
        <translation>identifiziert, %1</translation>
    </message>
    <message>
        <source>%1 let go</source>
        <translation>%1 losgelassen</translation>
    </message>
    <message>
        <source>The active table let go along %1: %2</source>
        <translation>Der aktive Tisch hat entlang %1 losgelassen: %2</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>The marker is in the file</source>
        <translation>Die Markierung steht in der Datei</translation>
    </message>
    <message>
        <source>Vibration %1</source>
        <translation>Schwingung %1</translation>
    </message>
    <message>
        <source>Vibration %1: the chatter is gone</source>
        <translation>Schwingung %1: Rattern weg</translation>
    </message>
    <message>
        <source>Vibration %1: no chatter, %2 is the teeth</source>
        <translation>Schwingung %1: kein Rattern, %2 Zähne</translation>
    </message>
    <message>
        <source>Onsets in this run: %1, no chatter</source>
        <translation>Ansätze in diesem Lauf: %1, kein Rattern</translation>
    </message>
    <message>
        <source>ADVICE IN THE REPLAY</source>
        <translation>RAT IN DER WIEDERGABE</translation>
    </message>
    <message>
        <source>live, %1</source>
        <translation>live, %1</translation>
    </message>
    <message>
        <source>being checked</source>
        <translation>in Prüfung</translation>
    </message>
    <message>
        <source>regenerative</source>
        <translation>regenerativ</translation>
    </message>
    <message>
        <source>Not computed so deep</source>
        <translation>So tief nicht berechnet</translation>
    </message>
    <message>
        <source>no limit found down to %1</source>
        <translation>bis %1 keine Grenze gefunden</translation>
    </message>
    <message>
        <source>STABLE, no limit found down to %1</source>
        <translation>STABIL, bis %1 keine Grenze gefunden</translation>
    </message>
    <message>
        <source>limit deeper than %1</source>
        <translation>Grenze tiefer als %1</translation>
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
        <translation>%1 eff.</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>Die Wiedergabe ist angehalten</translation>
    </message>
    <message>
        <source>Feed [%1]</source>
        <translation>Vorschub [%1]</translation>
    </message>
    <message>
        <source>Another run begins on the page Set up: GUIDE or PROFILE</source>
        <translation>Ein neuer Lauf beginnt auf der Seite Aufbau: ANLEITUNG oder PROFIL</translation>
    </message>
    <message>
        <source>%1, PAUSED</source>
        <translation>%1, ANGEHALTEN</translation>
    </message>
    <message>
        <source>%1, ENDED</source>
        <translation>%1, BEENDET</translation>
    </message>
    <message>
        <source>The onset of chatter was found once</source>
        <translation>Der Beginn von Rattern wurde einmal gefunden</translation>
    </message>
    <message>
        <source>The onset of chatter was found %1 times</source>
        <translation>Der Beginn von Rattern wurde %1 Mal gefunden</translation>
    </message>
    <message>
        <source>; it became no chatter</source>
        <translation>; es wurde kein Rattern daraus</translation>
    </message>
    <message>
        <source>Onset %1</source>
        <translation>Beginn %1</translation>
    </message>
    <message>
        <source>%1, going on</source>
        <translation>%1, dauert an</translation>
    </message>
    <message>
        <source>The controller starts, as many do when their port is opened: this takes up to 4 s</source>
        <translation>Die Steuerung startet, wie viele beim Öffnen ihres Anschlusses: das dauert bis zu 4 s</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Stillcut itself stands still for %1</source>
        <translation>Stillcut selbst steht seit %1 still</translation>
    </message>
    <message>
        <source>impossible values</source>
        <translation>unmögliche Werte</translation>
    </message>
    <message>
        <source>Leases run out</source>
        <translation>Abgelaufene Fristen</translation>
    </message>
    <message>
        <source>Standstills</source>
        <translation>Stillstände</translation>
    </message>
    <message>
        <source>Less depth of cut</source>
        <translation>Weniger Zustellung</translation>
    </message>
    <message>
        <source>%1 deep at most</source>
        <translation>höchstens %1 tief</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>ADVICE FOR YOUR HAND</source>
        <translation>RAT FÜR IHRE HAND</translation>
    </message>
    <message>
        <source>ADVICE FOR THE PROGRAM</source>
        <translation>RAT FÜR DAS PROGRAMM</translation>
    </message>
    <message>
        <source>STABLE SPEED</source>
        <translation>STABILE DREHZAHL</translation>
    </message>
    <message>
        <source>The spindle turns as advised and the cut is stable: keep it</source>
        <translation>Die Spindel dreht wie geraten und der Schnitt ist stabil: so lassen</translation>
    </message>
    <message>
        <source>ADVICE, AUTHORITY IS OFF</source>
        <translation>RAT, BEFUGNIS IST AUS</translation>
    </message>
    <message>
        <source>Touch ADVISE to use it</source>
        <translation>RAT berühren, um ihn zu nutzen</translation>
    </message>
    <message>
        <source>ACTIVE, HELD BY YOU</source>
        <translation>AKTIV, VON IHNEN GEHALTEN</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>AKTIV</translation>
    </message>
    <message>
        <source>Vibration, uncalibrated</source>
        <translation>Schwingung, unkalibriert</translation>
    </message>
    <message>
        <source>No machine link</source>
        <translation>Keine Maschine verbunden</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>not yet back</source>
        <translation>noch nicht zurück</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>antwortet</translation>
    </message>
    <message>
        <source>acts in %1</source>
        <translation>wirkt nach %1</translation>
    </message>
    <message>
        <source>louder: %1 times as before the move</source>
        <translation>lauter: %1-mal so viel wie vor dem Wechsel</translation>
    </message>
    <message>
        <source>the move did not help</source>
        <translation>der Wechsel hat nicht geholfen</translation>
    </message>
    <message>
        <source>%1; ended in Advise: %2 moves in a row without help</source>
        <translation>%1; endet in Rat: %2 Wechsel hintereinander ohne Hilfe</translation>
    </message>
    <message>
        <source>Onset %1, stable after %2, nothing marked</source>
        <translation>Beginn %1, stabil nach %2, nichts markiert</translation>
    </message>
    <message>
        <source>%1 when the tool left the cut</source>
        <translation>%1 bis zum Austritt des Werkzeugs</translation>
    </message>
    <message>
        <source>%1, stable after %2, %3 marked</source>
        <translation>%1, stabil nach %2, %3 Marken</translation>
    </message>
    <message>
        <source>no machine link: advice is for your hand</source>
        <translation>keine Maschinenverbindung: der Rat ist für Ihre Hand</translation>
    </message>
    <message>
        <source>NOT YET BACK</source>
        <translation>NOCH NICHT ZURÜCK</translation>
    </message>
    <message>
        <source>NOT YET BACK: now %1</source>
        <translation>NOCH NICHT ZURÜCK: jetzt %1</translation>
    </message>
    <message>
        <source>released, and the machine has not shown it yet</source>
        <translation>freigegeben, die Maschine zeigt es noch nicht</translation>
    </message>
    <message>
        <source>%1 active, alarms: %2, in alarm %3, energy ratio to %4</source>
        <translation>%1 aktiv, Alarme: %2, im Alarm %3, Energieanteil bis %4</translation>
    </message>
    <message>
        <source>The cut is stable</source>
        <translation>Der Schnitt ist stabil</translation>
    </message>
    <message>
        <source>not stable</source>
        <translation>nicht stabil</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>the cut was stable again.</source>
        <translation>der Schnitt war wieder stabil.</translation>
    </message>
    <message>
        <source>each time the cut was stable again.</source>
        <translation>jedes Mal war der Schnitt wieder stabil.</translation>
    </message>
    <message>
        <source>it did not become stable before the cut ended.</source>
        <translation>er wurde bis zum Ende des Schnitts nicht stabil.</translation>
    </message>
    <message>
        <source>once the cut was stable again before it ended.</source>
        <translation>einmal war der Schnitt vor seinem Ende wieder stabil.</translation>
    </message>
    <message>
        <source>%1 times the cut was stable again before it ended.</source>
        <translation>%1-mal war der Schnitt vor seinem Ende wieder stabil.</translation>
    </message>
    <message>
        <source>Stable after</source>
        <translation>Stabil nach</translation>
    </message>
    <message>
        <source>Choose a device</source>
        <translation>Gerät wählen</translation>
    </message>
    <message>
        <source>Or open files of a tap test, or drop them here.</source>
        <translation>Oder Dateien eines Klopfversuchs öffnen oder hierher ziehen.</translation>
    </message>
    <message>
        <source>Opening the device</source>
        <translation>Gerät wird geöffnet</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>Keine Messwerte</translation>
    </message>
    <message>
        <source>No sensor</source>
        <translation>Kein Sensor</translation>
    </message>
    <message>
        <source>None of its channels feels the tool.</source>
        <translation>Keiner seiner Kanäle spürt das Werkzeug.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Without a hammer: frequencies, damping and speeds to try; no stiffness, no depth.</source>
        <translation>Ohne Hammer: Frequenzen, Dämpfung und Drehzahlen zum Versuchen; keine Steifigkeit, keine Tiefe.</translation>
    </message>
    <message>
        <source>Press BEGIN, then hit the tip five times.</source>
        <translation>BEGINNEN drücken, dann fünfmal an die Spitze klopfen.</translation>
    </message>
    <message>
        <source>Refused: %1.</source>
        <translation>Abgelehnt: %1.</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>double hit</source>
        <translation>Doppelschlag</translation>
    </message>
    <message>
        <source>overload of the hammer</source>
        <translation>Hammer übersteuert</translation>
    </message>
    <message>
        <source>overload of the sensor</source>
        <translation>Sensor übersteuert</translation>
    </message>
    <message>
        <source>too weak</source>
        <translation>zu schwach</translation>
    </message>
    <message>
        <source>it still rang</source>
        <translation>schwang noch</translation>
    </message>
    <message>
        <source>samples were lost</source>
        <translation>Messwerte fehlen</translation>
    </message>
    <message>
        <source>differs from the others</source>
        <translation>weicht von den anderen ab</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Liest</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nicht gemessen</translation>
    </message>
    <message>
        <source>From files</source>
        <translation>Aus Dateien</translation>
    </message>
    <message>
        <source>%1 of %2 good hits along %3</source>
        <translation>%1 von %2 guten Schlägen längs %3</translation>
    </message>
    <message>
        <source>Be quiet</source>
        <translation>Still sein</translation>
    </message>
    <message>
        <source>The noise is being measured.</source>
        <translation>Das Rauschen wird gemessen.</translation>
    </message>
    <message>
        <source>HIT NOW</source>
        <translation>JETZT KLOPFEN</translation>
    </message>
    <message>
        <source>Listening</source>
        <translation>Hört zu</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Warten</translation>
    </message>
    <message>
        <source>It still rings. %1</source>
        <translation>Es schwingt noch. %1</translation>
    </message>
    <message>
        <source>Done along %1</source>
        <translation>Fertig längs %1</translation>
    </message>
    <message>
        <source>Turn hammer and sensor and measure y, or go on to MODES.</source>
        <translation>Hammer und Sensor drehen und y messen, oder weiter zu MODEN.</translation>
    </message>
    <message>
        <source>Go on to MODES.</source>
        <translation>Weiter zu MODEN.</translation>
    </message>
    <message>
        <source>Hit</source>
        <translation>Schlag</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>A touch takes it, or leaves it out</source>
        <translation>Ein Tipp nimmt ihn oder lässt ihn weg</translation>
    </message>
    <message>
        <source>Damping, %</source>
        <translation>Dämpfung, %</translation>
    </message>
    <message>
        <source>Soft, %</source>
        <translation>Weich, %</translation>
    </message>
    <message>
        <source>No modes yet</source>
        <translation>Noch keine Moden</translation>
    </message>
    <message>
        <source>Measure first, or tick a mode under MODES.</source>
        <translation>Erst messen, oder unter MODEN eine anhaken.</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Rechnet</translation>
    </message>
    <message>
        <source>Cannot be computed</source>
        <translation>Nicht zu berechnen</translation>
    </message>
    <message>
        <source>Try %1 rpm</source>
        <translation>%1 1/min versuchen</translation>
    </message>
    <message>
        <source>Speeds to try: %1. At these the tool swings whole times between two teeth. How deep cannot be told: that takes the force of a hammer.</source>
        <translation>Drehzahlen zum Versuchen: %1. Bei ihnen schwingt das Werkzeug ganze Male zwischen zwei Zähnen. Wie tief, lässt sich nicht sagen: dazu gehört die Kraft eines Hammers.</translation>
    </message>
    <message>
        <source>Removes %1. At any speed only %2 deep.</source>
        <translation>Zerspant %1. Bei jeder Drehzahl nur %2 tief.</translation>
    </message>
    <message>
        <source>The tool&apos;s length ends it, not chatter.</source>
        <translation>Die Länge des Werkzeugs begrenzt, nicht das Rattern.</translation>
    </message>
    <message>
        <source>Nine times in ten the true limit lies deeper; a tenth is taken off besides.</source>
        <translation>In neun von zehn Fällen liegt die wahre Grenze tiefer; ein Zehntel ist noch abgezogen.</translation>
    </message>
    <message>
        <source>%1 teeth</source>
        <translation>%1 Zähne</translation>
    </message>
    <message>
        <source>Judged again: %1</source>
        <translation>Neu beurteilt: %1</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>The simulated cut is over</source>
        <translation>Der simulierte Schnitt ist zu Ende</translation>
    </message>
    <message>
        <source>AGAIN runs it once more. Your own machine: the page Set up</source>
        <translation>NOCHMAL lässt ihn erneut laufen. Die eigene Maschine: Seite Aufbau</translation>
    </message>
    <message>
        <source>Stillcut moves the speed %1</source>
        <translation>Stillcut stellt die Drehzahl %1</translation>
    </message>
    <message>
        <source>Stillcut moves the feed %1</source>
        <translation>Stillcut stellt den Vorschub %1</translation>
    </message>
    <message>
        <source>Stillcut lets go: back to the operator&apos;s overrides</source>
        <translation>Stillcut lässt los: zurück zu den Overrides des Bedieners</translation>
    </message>
    <message>
        <source>The operator moves the speed override %1</source>
        <translation>Der Bediener stellt den Drehzahl-Override %1</translation>
    </message>
    <message>
        <source>The operator moves the feed override %1</source>
        <translation>Der Bediener stellt den Vorschub-Override %1</translation>
    </message>
    <message>
        <source>The program asks for another speed: %1</source>
        <translation>Das Programm verlangt eine andere Drehzahl: %1</translation>
    </message>
    <message>
        <source>Somebody has set %1</source>
        <translation>Jemand hat %1 gesetzt</translation>
    </message>
    <message>
        <source>the teeth shake least at %1, %2</source>
        <translation>am ruhigsten laufen die Zähne bei %1, %2</translation>
    </message>
    <message>
        <source>without Stillcut %1</source>
        <translation>ohne Stillcut %1</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Von Hand gesetzt</translation>
    </message>
    <message>
        <source>As delivered</source>
        <translation>Wie ausgeliefert</translation>
    </message>
    <message>
        <source>One step more sensitive</source>
        <translation>Eine Stufe empfindlicher</translation>
    </message>
    <message>
        <source>One step less sensitive</source>
        <translation>Eine Stufe unempfindlicher</translation>
    </message>
    <message>
        <source>%1 steps more sensitive</source>
        <translation>%1 Stufen empfindlicher</translation>
    </message>
    <message>
        <source>%1 steps less sensitive</source>
        <translation>%1 Stufen unempfindlicher</translation>
    </message>
    <message>
        <source>Looking at your last recordings</source>
        <translation>Sieht die letzten Aufnahmen durch</translation>
    </message>
    <message>
        <source>There are no recordings yet to try it on</source>
        <translation>Noch keine Aufnahmen, an denen es sich erproben ließe</translation>
    </message>
    <message>
        <source>In your last recording it would have alarmed %1 times, %2 of them marked false</source>
        <translation>In der letzten Aufnahme hätte es %1-mal Alarm gegeben, davon %2 als falsch markiert</translation>
    </message>
    <message>
        <source>In your last %1 recordings it would have alarmed %2 times, %3 of them marked false</source>
        <translation>In den letzten %1 Aufnahmen hätte es %2-mal Alarm gegeben, davon %3 als falsch markiert</translation>
    </message>
    <message>
        <source>; as they were recorded %1 times, %2 of them marked false</source>
        <translation>; wie aufgenommen %1-mal, davon %2 als falsch markiert</translation>
    </message>
    <message>
        <source>; looking at more</source>
        <translation>; sieht weitere durch</translation>
    </message>
    <message>
        <source>.</source>
        <translation>,</translation>
    </message>
    <message>
        <source>It does not run again: %1. AGAIN tries once more</source>
        <translation>Er läuft nicht noch einmal: %1. NOCHMAL versucht es wieder</translation>
    </message>
    <message>
        <source>recordings: %1, %2</source>
        <translation>Aufnahmen: %1, %2</translation>
    </message>
    <message>
        <source>alarms: %1</source>
        <translation>Alarme: %1</translation>
    </message>
    <message>
        <source>%1, %2 an hour, %3 long</source>
        <translation>%1, %2 je Stunde, %3 lang</translation>
    </message>
    <message>
        <source>As the run ended</source>
        <translation>Wie der Lauf endete</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>Nothing was measured along %1: taken as rigid there. The true limit may be far lower; measure it first.</source>
        <translation>Entlang %1 wurde nichts gemessen: dort als starr angenommen. Die wahre Grenze kann viel kleiner sein; zuerst messen.</translation>
    </message>
    <message>
        <source>Onset at %1, energy ratio %2</source>
        <translation>Beginn bei %1, Energieverhältnis %2</translation>
    </message>
    <message>
        <source>WHAT COMES NEXT</source>
        <translation>WAS ALS NÄCHSTES KOMMT</translation>
    </message>
    <message>
        <source>ADVICE, IN A MOMENT</source>
        <translation>RAT, GLEICH</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>AUFNAHME</translation>
    </message>
    <message>
        <source>NETWORK</source>
        <translation>NETZ</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Too slow</source>
        <translation>Zu langsam</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzug</translation>
    </message>
    <message>
        <source>%1 behind</source>
        <translation>%1 zurück</translation>
    </message>
    <message>
        <source>What the file does not say</source>
        <translation>Was die Datei nicht sagt</translation>
    </message>
    <message>
        <source>Channel of the hammer</source>
        <translation>Kanal des Hammers</translation>
    </message>
    <message>
        <source>its name, or its number from 0</source>
        <translation>sein Name oder seine Nummer ab 0</translation>
    </message>
    <message>
        <source>Channel of the sensor</source>
        <translation>Kanal des Sensors</translation>
    </message>
    <message>
        <source>Unit of the force</source>
        <translation>Einheit der Kraft</translation>
    </message>
    <message>
        <source>Unit of the response</source>
        <translation>Einheit der Antwort</translation>
    </message>
    <message>
        <source>Sensitivity of the hammer</source>
        <translation>Empfindlichkeit des Hammers</translation>
    </message>
    <message>
        <source>Sensitivity of the sensor</source>
        <translation>Empfindlichkeit des Sensors</translation>
    </message>
    <message>
        <source>Force at full scale</source>
        <translation>Kraft bei Vollausschlag</translation>
    </message>
    <message>
        <source>in the unit beside it</source>
        <translation>in der Einheit daneben</translation>
    </message>
    <message>
        <source>Response at full scale</source>
        <translation>Antwort bei Vollausschlag</translation>
    </message>
    <message>
        <source>Unit of the frequency response</source>
        <translation>Einheit des Frequenzgangs</translation>
    </message>
    <message>
        <source>Unit of the frequencies</source>
        <translation>Einheit der Frequenzen</translation>
    </message>
    <message>
        <source>Unit of the phase</source>
        <translation>Einheit der Phase</translation>
    </message>
    <message>
        <source>%1 behind: this computer does not keep up with the samples</source>
        <translation>%1 zurück: Dieser Rechner kommt mit den Messwerten nicht nach</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>WIEDERGABE</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>Aufnahmen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Stillcut moved speed and feed; </source>
        <translation>Stillcut hat Drehzahl und Vorschub verstellt; </translation>
    </message>
    <message>
        <source>Stillcut moved speed and feed after %1 of them; </source>
        <translation>Nach %1 davon hat Stillcut Drehzahl und Vorschub verstellt; </translation>
    </message>
    <message>
        <source>Speed [%1]</source>
        <translation>Drehzahl [%1]</translation>
    </message>
    <message>
        <source>Cut report</source>
        <translation>Schnittbericht</translation>
    </message>
    <message>
        <source>Alarms and what was done</source>
        <translation>Alarme und was getan wurde</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Sensor check</source>
        <translation>Sensorprüfung</translation>
    </message>
    <message>
        <source>Settings changed during the cut</source>
        <translation>Während des Schnitts geändert</translation>
    </message>
    <message>
        <source>Settings at the beginning</source>
        <translation>Einstellungen zu Beginn</translation>
    </message>
    <message>
        <source>AUDIO</source>
        <translation>AUDIO</translation>
    </message>
    <message>
        <source>DAQ CARD</source>
        <translation>DAQ</translation>
    </message>
    <message>
        <source>IIO</source>
        <translation>IIO</translation>
    </message>
    <message>
        <source>SERIAL</source>
        <translation>SERIELL</translation>
    </message>
    <message>
        <source>JOINED</source>
        <translation>VERBUND</translation>
    </message>
    <message>
        <source>, marked: was chatter</source>
        <translation>, markiert: richtiger Alarm</translation>
    </message>
    <message>
        <source>, marked: false alarm</source>
        <translation>, markiert: Fehlalarm</translation>
    </message>
    <message>
        <source>Stable again after %1</source>
        <translation>Wieder stabil nach %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ActiveView</name>
    <message>
        <source>IDENTIFY</source>
        <translation>ERMITTELN</translation>
    </message>
    <message>
        <source>Identify the paths, with the tool out of the cut</source>
        <translation>Die Strecken ermitteln, mit dem Werkzeug außer Eingriff</translation>
    </message>
    <message>
        <source>START</source>
        <translation>START</translation>
    </message>
    <message>
        <source>Start active control</source>
        <translation>Aktive Regelung starten</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>HALT</translation>
    </message>
    <message>
        <source>Stop active control</source>
        <translation>Aktive Regelung anhalten</translation>
    </message>
    <message>
        <source>Axis x</source>
        <translation>Achse x</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>Achse y</translation>
    </message>
    <message>
        <source>There is no active work-holder here.</source>
        <translation>Hier gibt es keinen aktiven Tisch.</translation>
    </message>
    <message>
        <source>%1: nothing yet</source>
        <translation>%1: noch nichts</translation>
    </message>
    <message>
        <source>Nothing is known of its lines yet</source>
        <translation>Von seinen Linien ist noch nichts bekannt</translation>
    </message>
    <message>
        <source>By the model, against the cut left alone: %1</source>
        <translation>Nach dem Modell, gegen den Schnitt ohne Regelung: %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::AdvicePanel</name>
    <message>
        <source>ACCEPT</source>
        <translation>ANNEHMEN</translation>
    </message>
    <message>
        <source>NOT NOW</source>
        <translation>JETZT NICHT</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>AGAIN</source>
        <translation>NOCHMAL</translation>
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
        <translation>WASSERFALL</translation>
    </message>
    <message>
        <source>LINEAR</source>
        <translation>LINEAR</translation>
    </message>
    <message>
        <source>ORDERS</source>
        <translation>ORDNUNG</translation>
    </message>
    <message>
        <source>MAX HOLD</source>
        <translation>MAX HALTEN</translation>
    </message>
    <message>
        <source>REFERENCE</source>
        <translation>REFERENZ</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Channel of spectrogram, spectrum and signal</source>
        <translation>Kanal von Spektrogramm, Spektrum und Signal</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>DATEI</translation>
    </message>
    <message>
        <source>EVENTS</source>
        <translation>LOG</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ChannelModel</name>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Per device unit</source>
        <translation>Je Geräteeinheit</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::CommandBar</name>
    <message>
        <source>OFF</source>
        <translation>AUS</translation>
    </message>
    <message>
        <source>ADVISE</source>
        <translation>RAT</translation>
    </message>
    <message>
        <source>AUTO</source>
        <translation>AUTOMATIK</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>HALTEN</translation>
    </message>
    <message>
        <source>BACK TO 100 %</source>
        <translation>ZURÜCK AUF 100 %</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>Befugnis</translation>
    </message>
    <message>
        <source>This profile does not grant Auto</source>
        <translation>Dieses Profil erlaubt Automatik nicht</translation>
    </message>
    <message>
        <source>END HOLD</source>
        <translation>HALT ENDE</translation>
    </message>
    <message>
        <source>AUTO?</source>
        <translation>AUTOMATIK?</translation>
    </message>
    <message>
        <source>touch again to confirm</source>
        <translation>nochmals berühren</translation>
    </message>
    <message>
        <source>This machine has no watchdog</source>
        <translation>Diese Maschine hat keinen Wächter</translation>
    </message>
    <message>
        <source>if Stillcut dies, its overrides stay</source>
        <translation>fällt Stillcut aus, bleiben die Overrides</translation>
    </message>
    <message>
        <source>F4, no watchdog</source>
        <translation>F4, ohne Watchdog</translation>
    </message>
    <message>
        <source>ACCEPT</source>
        <translation>ANNEHMEN</translation>
    </message>
    <message>
        <source>No machine link: the advice is for your hand</source>
        <translation>Keine Maschinenverbindung: der Rat ist für Ihre Hand</translation>
    </message>
    <message>
        <source>No machine link: there is nothing to move</source>
        <translation>Keine Maschinenverbindung: es gibt nichts zu verstellen</translation>
    </message>
    <message>
        <source>%1, now %2</source>
        <translation>%1, jetzt %2</translation>
    </message>
    <message>
        <source>cable out or keeper dead: they stay</source>
        <translation>Kabel ab, Hüter tot: sie bleiben</translation>
    </message>
    <message>
        <source>The run is over: there is nothing to advise on</source>
        <translation>Der Lauf ist zu Ende: Es gibt nichts zu raten</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ComponentListModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::CutForm</name>
    <message>
        <source>OPEN FILE</source>
        <translation>DATEI ÖFFNEN</translation>
    </message>
    <message>
        <source>Take a cut, a scenario, a profile or modes from a file</source>
        <translation>Schnitt, Szenario, Profil oder Moden aus einer Datei nehmen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Cutting force, along</source>
        <translation>Kraft tangential</translation>
    </message>
    <message>
        <source>Cutting force, across</source>
        <translation>Kraft radial</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Helix angle</source>
        <translation>Drallwinkel</translation>
    </message>
    <message>
        <source>Width of cut</source>
        <translation>Eingriffsbreite</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>Vorschub je Zahn</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>Schnitttiefe</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>Kleinste Drehzahl</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Größte Drehzahl</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>nicht genannt</translation>
    </message>
    <message>
        <source>ADD MODE</source>
        <translation>MODE DAZU</translation>
    </message>
    <message>
        <source>Add a row for a mode</source>
        <translation>Eine Zeile für eine Mode anfügen</translation>
    </message>
    <message>
        <source>REMOVE MODE</source>
        <translation>MODE WEG</translation>
    </message>
    <message>
        <source>Remove the chosen mode</source>
        <translation>Die gewählte Mode entfernen</translation>
    </message>
    <message>
        <source>SHOW LOBES</source>
        <translation>KURVE ZEIGEN</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>Gegenlauf</translation>
    </message>
    <message>
        <source>Modes of tool and holder at the tip</source>
        <translation>Moden von Werkzeug und Halter an der Spitze</translation>
    </message>
    <message>
        <source>along</source>
        <translation>entlang</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>damping, %</source>
        <translation>Dämpfung, %</translation>
    </message>
    <message>
        <source>stiffness, N/µm</source>
        <translation>Steifigkeit, N/µm</translation>
    </message>
    <message>
        <source>by its forces</source>
        <translation>nach Kräften</translation>
    </message>
    <message>
        <source>Your own cut: type it, or open a file</source>
        <translation>Eigener Schnitt: eintippen oder eine Datei öffnen</translation>
    </message>
    <message>
        <source>A cut, a scenario, a profile or modes</source>
        <translation>Schnitt, Szenario, Profil oder Moden</translation>
    </message>
    <message>
        <source>Milling direction</source>
        <translation>Fräsrichtung</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>Größte Tiefe</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::DisplayPanel</name>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>LIGHT</source>
        <translation>HELL</translation>
    </message>
    <message>
        <source>DARK</source>
        <translation>DUNKEL</translation>
    </message>
    <message>
        <source>HIGH CONTRAST</source>
        <translation>HOHER KONTRAST</translation>
    </message>
    <message>
        <source>METRIC</source>
        <translation>METRISCH</translation>
    </message>
    <message>
        <source>INCH</source>
        <translation>ZOLL</translation>
    </message>
    <message>
        <source>HELP</source>
        <translation>HILFE</translation>
    </message>
    <message>
        <source>The manual of this page</source>
        <translation>Das Handbuch zu dieser Seite</translation>
    </message>
    <message>
        <source>TEXT</source>
        <translation>SCHRIFT</translation>
    </message>
    <message>
        <source>LARGE TEXT</source>
        <translation>GROSSE SCHRIFT</translation>
    </message>
    <message>
        <source>LARGEST TEXT</source>
        <translation>GRÖSSTE SCHRIFT</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::EventPanel</name>
    <message>
        <source>What happened at 13:58, or a word</source>
        <translation>Was war um 13:58, oder ein Wort</translation>
    </message>
    <message>
        <source>Search the events by time of day or by a word</source>
        <translation>Ereignisse nach Uhrzeit oder Wort suchen</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschehen ist</translation>
    </message>
    <message>
        <source>Nothing has happened yet</source>
        <translation>Noch ist nichts geschehen</translation>
    </message>
    <message>
        <source>Nothing like that</source>
        <translation>Nichts dergleichen</translation>
    </message>
    <message>
        <source>Nothing at %1. The nearest is chosen</source>
        <translation>Nichts um %1. Das Nächstliegende ist gewählt</translation>
    </message>
    <message>
        <source>WAS CHATTER</source>
        <translation>RICHTIGER ALARM</translation>
    </message>
    <message>
        <source>The chosen alarm was chatter</source>
        <translation>Der gewählte Alarm war Rattern</translation>
    </message>
    <message>
        <source>FALSE ALARM</source>
        <translation>FEHLALARM</translation>
    </message>
    <message>
        <source>The chosen alarm was no chatter</source>
        <translation>Der gewählte Alarm war kein Rattern</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FileAnswerPanel</name>
    <message>
        <source>OPEN A RECORDING</source>
        <translation>AUFNAHME ÖFFNEN</translation>
    </message>
    <message>
        <source>Choose a recording to look at</source>
        <translation>Eine Aufnahme zum Ansehen wählen</translation>
    </message>
    <message>
        <source>Your recording</source>
        <translation>Ihre Aufnahme</translation>
    </message>
    <message>
        <source>Reading, %1</source>
        <translation>Wird gelesen, %1</translation>
    </message>
    <message>
        <source>Chatter or not, the reason, and the speed that helps. Drop a file on this window, or open one: sound of a phone, a table, a logger&apos;s file, a session.</source>
        <translation>Rattern oder nicht, der Grund, und die Drehzahl, die hilft. Eine Datei auf das Fenster ziehen oder öffnen: Ton vom Telefon, eine Tabelle, die Datei eines Loggers, ein Lauf.</translation>
    </message>
    <message>
        <source>Cannot be judged</source>
        <translation>Nicht beurteilbar</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>Nicht lesbar</translation>
    </message>
    <message>
        <source>Judging, %1</source>
        <translation>Wird beurteilt, %1</translation>
    </message>
    <message>
        <source>In the signal: %1 rpm</source>
        <translation>Im Signal: %1 1/min</translation>
    </message>
    <message>
        <source>In the signal: %1 rpm, or %2</source>
        <translation>Im Signal: %1 1/min, oder %2</translation>
    </message>
    <message>
        <source>Teeth by the signal: %1</source>
        <translation>Zähne nach dem Signal: %1</translation>
    </message>
    <message>
        <source>Teeth by the signal: %1, or %2</source>
        <translation>Zähne nach dem Signal: %1, oder %2</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Verglichen mit %1</translation>
    </message>
    <message>
        <source>As loud in the cut as the first, if both were recorded alike</source>
        <translation>Im Schnitt so laut wie die erste, wenn beide gleich aufgenommen wurden</translation>
    </message>
    <message>
        <source>%1 louder in the cut than the first, if both were recorded alike</source>
        <translation>Im Schnitt %1 lauter als die erste, wenn beide gleich aufgenommen wurden</translation>
    </message>
    <message>
        <source>%1 quieter in the cut than the first, if both were recorded alike</source>
        <translation>Im Schnitt %1 leiser als die erste, wenn beide gleich aufgenommen wurden</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FilePage</name>
    <message>
        <source>No recording can be opened here.</source>
        <translation>Hier kann keine Aufnahme geöffnet werden.</translation>
    </message>
    <message>
        <source>LISTEN</source>
        <translation>ANHÖREN</translation>
    </message>
    <message>
        <source>Play the sound of the stretch on show</source>
        <translation>Den gezeigten Abschnitt als Ton abspielen</translation>
    </message>
    <message>
        <source>PICTURE</source>
        <translation>BILD</translation>
    </message>
    <message>
        <source>Write a picture of this page beside the recording</source>
        <translation>Ein Bild dieser Seite neben die Aufnahme schreiben</translation>
    </message>
    <message>
        <source>REPORT</source>
        <translation>BERICHT</translation>
    </message>
    <message>
        <source>Write a report of this recording beside it</source>
        <translation>Einen Bericht dieser Aufnahme daneben schreiben</translation>
    </message>
    <message>
        <source>The report is being made</source>
        <translation>Der Bericht entsteht</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufnahme öffnen</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>COMPARE</source>
        <translation>VERGLEICH</translation>
    </message>
    <message>
        <source>Compare with a second recording</source>
        <translation>Mit einer zweiten Aufzeichnung vergleichen</translation>
    </message>
    <message>
        <source>Open the recording to compare with</source>
        <translation>Aufzeichnung zum Vergleich öffnen</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>Vergleich</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FileSpectrum</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom. Double click: all.</source>
        <translation>Klick: Harmonischen-Cursor. H: auf die stärkste Linie. Ziehen: verschieben. Rad: zoomen. Doppelklick: alles.</translation>
    </message>
    <message>
        <source>, order %1</source>
        <translation>, Ordnung %1</translation>
    </message>
    <message>
        <source>SPECTRUM AT A, %1</source>
        <translation>SPEKTRUM BEI A, %1</translation>
    </message>
    <message>
        <source>SPECTRUM, MEAN</source>
        <translation>SPEKTRUM, MITTEL</translation>
    </message>
    <message>
        <source>order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>Rattern %1</translation>
    </message>
    <message>
        <source>, compared %1</source>
        <translation>, Vergleich %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FileTools</name>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Samples of one spectrum</source>
        <translation>Werte je Spektrum</translation>
    </message>
    <message>
        <source>Window of the spectra</source>
        <translation>Fenster der Spektren</translation>
    </message>
    <message>
        <source>Hann</source>
        <translation>Hann</translation>
    </message>
    <message>
        <source>Flat top</source>
        <translation>Flattop</translation>
    </message>
    <message>
        <source>Rectangular</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Overlap of the spectra</source>
        <translation>Überlappung der Spektren</translation>
    </message>
    <message>
        <source>LOG</source>
        <translation>LOG</translation>
    </message>
    <message>
        <source>Logarithmic axis of frequency</source>
        <translation>Logarithmische Frequenzachse</translation>
    </message>
    <message>
        <source>ORDERS</source>
        <translation>ORDNUNGEN</translation>
    </message>
    <message>
        <source>Frequencies as orders of the spindle</source>
        <translation>Frequenzen als Ordnungen der Spindel</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::FrfPlot</name>
    <message>
        <source>Frequency response at the tip</source>
        <translation>Frequenzgang an der Spitze</translation>
    </message>
    <message>
        <source>Coherence; below the mark it says little</source>
        <translation>Kohärenz; unter der Marke sagt sie wenig</translation>
    </message>
    <message>
        <source>One hit only: not known</source>
        <translation>Nur ein Schlag: nicht bekannt</translation>
    </message>
    <message>
        <source>No hammer: not known</source>
        <translation>Kein Hammer: nicht bekannt</translation>
    </message>
    <message>
        <source>Here the response of the tool appears with the first good hit.</source>
        <translation>Hier erscheint mit dem ersten guten Schlag die Antwort des Werkzeugs.</translation>
    </message>
    <message>
        <source>Real part; dashed: the modes</source>
        <translation>Realteil; gestrichelt: die Moden</translation>
    </message>
    <message>
        <source>Imaginary part</source>
        <translation>Imaginärteil</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::HeaderBar</name>
    <message>
        <source>SIMULATED MACHINE</source>
        <translation>SIMULIERTE MASCHINE</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Theme, units, language (F11); next theme (F12)</source>
        <translation>Farben, Einheiten, Sprache (F11); nächste Farben (F12)</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::HistoryMap</name>
    <message>
        <source>SPECTROGRAM</source>
        <translation>SPEKTROGRAMM</translation>
    </message>
    <message>
        <source>Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Click: cursor A, with Shift B.</source>
        <translation>Ziehen: verschieben. Rad: zoomen. Strg und Ziehen: auf einen Abschnitt zoomen. Klick: Cursor A, mit Umschalt B.</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>Wartet auf die ersten Messwerte</translation>
    </message>
    <message>
        <source>order</source>
        <translation>Ordnung</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::IndicatorStrip</name>
    <message>
        <source>%1, limit %2</source>
        <translation>%1, Grenze %2</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>Grenze %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::InterventionList</name>
    <message>
        <source>WAS CHATTER</source>
        <translation>RICHTIGER ALARM</translation>
    </message>
    <message>
        <source>FALSE ALARM</source>
        <translation>FEHLALARM</translation>
    </message>
    <message>
        <source>Last interventions</source>
        <translation>Letzte Eingriffe</translation>
    </message>
    <message>
        <source>LAST INTERVENTIONS</source>
        <translation>LETZTE EINGRIFFE</translation>
    </message>
    <message>
        <source>None in this run</source>
        <translation>Keine in diesem Lauf</translation>
    </message>
    <message>
        <source>MISSED CHATTER</source>
        <translation>VERPASST</translation>
    </message>
    <message>
        <source>Marks chatter now that no alarm told of; another touch takes the mark back</source>
        <translation>Merkt jetzt Rattern an, das kein Alarm gemeldet hat; noch eine Berührung nimmt die Marke zurück</translation>
    </message>
    <message>
        <source>%1 undoes it</source>
        <translation>%1 nimmt zurück</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LevelSpectrum</name>
    <message>
        <source>Spectrum of the first channel, now</source>
        <translation>Spektrum des ersten Kanals, jetzt</translation>
    </message>
    <message>
        <source>No samples come</source>
        <translation>Es kommen keine Messwerte</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LobeChart</name>
    <message>
        <source>Stability diagram</source>
        <translation>Stabilitätsdiagramm</translation>
    </message>
    <message>
        <source>spindle speed [rpm]</source>
        <translation>Drehzahl [1/min]</translation>
    </message>
    <message>
        <source>depth of cut [in]</source>
        <translation>Schnitttiefe [in]</translation>
    </message>
    <message>
        <source>depth of cut [mm]</source>
        <translation>Schnitttiefe [mm]</translation>
    </message>
    <message>
        <source>Drag the ring, or use the arrow keys: what if the cut ran at this speed and depth? Two fingers, the wheel or plus and minus zoom, zero shows the whole.</source>
        <translation>Den Ring ziehen oder mit den Pfeiltasten bewegen: was wäre, wenn der Schnitt mit dieser Drehzahl und Tiefe liefe? Zwei Finger, das Mausrad oder Plus und Minus vergrößern, Null zeigt das Ganze.</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::LobesPage</name>
    <message>
        <source>ZEROTH ORDER</source>
        <translation>NULLTE ORD.</translation>
    </message>
    <message>
        <source>SEMI-DISCRETE</source>
        <translation>SEMIDISKRET</translation>
    </message>
    <message>
        <source>EXACT</source>
        <translation>EXAKT</translation>
    </message>
    <message>
        <source>COMPUTE</source>
        <translation>BERECHNEN</translation>
    </message>
    <message>
        <source>Progress of the diagram</source>
        <translation>Fortschritt des Diagramms</translation>
    </message>
    <message>
        <source>What if the speed were</source>
        <translation>Was wäre bei Drehzahl</translation>
    </message>
    <message>
        <source>and the depth</source>
        <translation>und Tiefe</translation>
    </message>
    <message>
        <source>Speed, what if</source>
        <translation>Drehzahl, was wäre wenn</translation>
    </message>
    <message>
        <source>Depth, what if</source>
        <translation>Tiefe, was wäre wenn</translation>
    </message>
    <message>
        <source>CANCEL</source>
        <translation>ABBRECHEN</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Cannot be computed: %1</source>
        <translation>Kann nicht berechnet werden: %1</translation>
    </message>
    <message>
        <source>In brackets: beyond the override&apos;s reach</source>
        <translation>In Klammern: außerhalb der Reichweite des Overrides</translation>
    </message>
    <message>
        <source>Choose a pocket to try its best speed</source>
        <translation>Einen Bereich wählen, um seine beste Drehzahl zu versuchen</translation>
    </message>
    <message>
        <source>Nothing new arrives: the working point is not shown</source>
        <translation>Nichts Neues kommt an: Der Arbeitspunkt wird nicht gezeigt</translation>
    </message>
    <message>
        <source>The recording does not say which modes its tool has: there is no diagram of this cut. The machine&apos;s own comes back with its cut.</source>
        <translation>Die Aufnahme sagt nicht, welche Moden ihr Werkzeug hat: von diesem Schnitt gibt es kein Diagramm. Das der Maschine kommt mit ihrem Schnitt zurück.</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>Die Wiedergabe ist angehalten</translation>
    </message>
    <message>
        <source>The depth of cut is not known: tell it under Set up, MACHINE, and the working point is shown</source>
        <translation>Die Schnitttiefe ist nicht bekannt: unter Aufbau, MASCHINE eintragen, dann wird der Arbeitspunkt gezeigt</translation>
    </message>
    <message>
        <source>, depth of cut up to %1</source>
        <translation>, Schnitttiefe bis %1</translation>
    </message>
    <message>
        <source>The modes of this tool are not known. A tap test gives the file of its modes (F1 tells how): name it under Set up, TOOLS; the diagram needs nothing else.</source>
        <translation>Die Moden dieses Werkzeugs sind nicht bekannt. Ein Klopfversuch gibt die Datei der Moden (F1 sagt wie): unter Aufbau, WERKZEUGE nennen; mehr braucht das Diagramm nicht.</translation>
    </message>
    <message>
        <source>Stable speeds at this depth</source>
        <translation>Stabile Drehzahlen in dieser Tiefe</translation>
    </message>
    <message>
        <source>THE CUT THAT RUNS</source>
        <translation>LAUFENDER SCHNITT</translation>
    </message>
    <message>
        <source>Lobes of the cut that runs or is replayed</source>
        <translation>Kurve des Schnitts, der läuft oder wiedergegeben wird</translation>
    </message>
    <message>
        <source>YOUR OWN CUT</source>
        <translation>EIGENER SCHNITT</translation>
    </message>
    <message>
        <source>Enter a cut, or open a file with one</source>
        <translation>Einen Schnitt eingeben oder aus einer Datei öffnen</translation>
    </message>
    <message>
        <source>Enter tool, modes, material and engagement, or open a file: no machine and no run is needed.</source>
        <translation>Werkzeug, Moden, Werkstoff und Eingriff eingeben oder eine Datei öffnen: es braucht weder Maschine noch Lauf.</translation>
    </message>
    <message>
        <source>Or touch YOUR OWN CUT and enter them here.</source>
        <translation>Oder EIGENER SCHNITT berühren und sie hier eingeben.</translation>
    </message>
    <message>
        <source>BACK TO THE LOBES</source>
        <translation>ZURÜCK ZUR KURVE</translation>
    </message>
    <message>
        <source>CHANGE YOUR CUT</source>
        <translation>SCHNITT ÄNDERN</translation>
    </message>
    <message>
        <source>Computing; the diagram becomes finer until it is done</source>
        <translation>Rechnet; das Diagramm wird feiner, bis es fertig ist</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Rechnet</translation>
    </message>
    <message>
        <source>No speed is stable at %1. The deepest stable cut: %2 at %3</source>
        <translation>Bei %1 ist keine Drehzahl stabil. Der tiefste stabile Schnitt: %2 bei %3</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MachinePlot</name>
    <message>
        <source>MACHINE</source>
        <translation>MASCHINE</translation>
    </message>
    <message>
        <source>thick: what it did; thin: programmed; overrides: thick speed, thin feed</source>
        <translation>dick: was sie tat; dünn: programmiert; Override: dick Drehzahl, dünn Vorschub</translation>
    </message>
    <message>
        <source>Speed, feed and overrides as they were read back</source>
        <translation>Drehzahl, Vorschub und Override, wie zurückgelesen</translation>
    </message>
    <message>
        <source>Nothing was read from a machine</source>
        <translation>Von keiner Maschine wurde etwas gelesen</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ManualPanel</name>
    <message>
        <source>CONTENTS</source>
        <translation>INHALT</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>ZURÜCK</translation>
    </message>
    <message>
        <source>CLOSE</source>
        <translation>SCHLIESSEN</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::MarkSheet</name>
    <message>
        <source>Label</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Label of the span</source>
        <translation>Name der Spanne</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Note of the next marker</source>
        <translation>Notiz der nächsten Markierung</translation>
    </message>
    <message>
        <source>SPAN</source>
        <translation>SPANNE</translation>
    </message>
    <message>
        <source>Mark the selected span with the label</source>
        <translation>Gewählte Spanne mit dem Namen markieren</translation>
    </message>
    <message>
        <source>CHANGE</source>
        <translation>ÄNDERN</translation>
    </message>
    <message>
        <source>Give the chosen marker this label and note</source>
        <translation>Der gewählten Markierung diesen Namen und diese Notiz geben</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>ENTFERNEN</translation>
    </message>
    <message>
        <source>Remove the chosen marker</source>
        <translation>Gewählte Markierung entfernen</translation>
    </message>
    <message>
        <source>CHATTER</source>
        <translation>RATTERN</translation>
    </message>
    <message>
        <source>Mark a true alarm</source>
        <translation>Echten Alarm markieren</translation>
    </message>
    <message>
        <source>FALSE</source>
        <translation>FALSCH</translation>
    </message>
    <message>
        <source>Mark a false alarm</source>
        <translation>Fehlalarm markieren</translation>
    </message>
    <message>
        <source>I hear it now</source>
        <translation>Ich höre es jetzt</translation>
    </message>
    <message>
        <source>NOTE</source>
        <translation>NOTIZ</translation>
    </message>
    <message>
        <source>Mark with the note</source>
        <translation>Mit der Notiz markieren</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Marked: %1</source>
        <translation>Markiert: %1</translation>
    </message>
    <message>
        <source>Marker changed</source>
        <translation>Markierung geändert</translation>
    </message>
    <message>
        <source>Marker removed</source>
        <translation>Markierung entfernt</translation>
    </message>
    <message>
        <source>Marker put back</source>
        <translation>Markierung zurückgeholt</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>ZURÜCK</translation>
    </message>
    <message>
        <source>MISSED CHATTER</source>
        <translation>VERPASST</translation>
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
        <translation>Unscharfe Mengen</translation>
    </message>
    <message>
        <source>How far an error belongs to each set</source>
        <translation>Wie weit ein Fehler zu jeder Menge gehört</translation>
    </message>
    <message>
        <source>Peaks at %1, %2, %3 of the range</source>
        <translation>Spitzen bei %1, %2, %3 des Bereichs</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::OperatePage</name>
    <message>
        <source>channel %1</source>
        <translation>Kanal %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::OverrideTable</name>
    <message>
        <source>Speed and feed</source>
        <translation>Drehzahl und Vorschub</translation>
    </message>
    <message>
        <source>%1: programmed %2, override %3, actual %4 %5</source>
        <translation>%1: programmiert %2, Override %3, tatsächlich %4 %5</translation>
    </message>
    <message>
        <source>programmed</source>
        <translation>programmiert</translation>
    </message>
    <message>
        <source>override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>tatsächlich</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ParamModel</name>
    <message>
        <source>Locked while the cut runs: the limits of the machine hold for a whole run</source>
        <translation>Gesperrt, solange der Schnitt läuft: die Grenzen der Maschine gelten für einen ganzen Lauf</translation>
    </message>
    <message>
        <source>Locked while the cut runs: a file keeps one way of recording</source>
        <translation>Gesperrt, solange der Schnitt läuft: eine Datei behält eine Art der Aufnahme</translation>
    </message>
    <message>
        <source>Locked while the cut runs: filters and windows are sized for it before the first block</source>
        <translation>Gesperrt, solange der Schnitt läuft: Filter und Fenster werden vor dem ersten Block danach bemessen</translation>
    </message>
    <message>
        <source>follows what is learned from the cut</source>
        <translation>folgt dem, was aus dem Schnitt gelernt wird</translation>
    </message>
    <message>
        <source>chose %1</source>
        <translation>wählte %1</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
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
        <translation>gewählt %1 (%2)</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ParamRow</name>
    <message>
        <source>Less: %1</source>
        <translation>Weniger: %1</translation>
    </message>
    <message>
        <source>More: %1</source>
        <translation>Mehr: %1</translation>
    </message>
    <message>
        <source>AUTO</source>
        <translation>AUTO</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatisch: %1</translation>
    </message>
    <message>
        <source>Not taken. Allowed: %1</source>
        <translation>Nicht übernommen. Erlaubt: %1</translation>
    </message>
    <message>
        <source>%1   (A and B differ)</source>
        <translation>%1   (A und B verschieden)</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Vorgabe: %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PathFitPlot</name>
    <message>
        <source>Fit of the path&apos;s model</source>
        <translation>Güte des Streckenmodells</translation>
    </message>
    <message>
        <source>No model: identify the path</source>
        <translation>Kein Modell: die Strecke ermitteln</translation>
    </message>
    <message>
        <source>Phase error; hatched: control goes wrong</source>
        <translation>Phasenfehler; schraffiert: Regelung geht fehl</translation>
    </message>
    <message>
        <source>Coherence; below the mark it says little</source>
        <translation>Kohärenz; unter der Marke sagt sie wenig</translation>
    </message>
    <message>
        <source>Magnitude: measured grey, model blue and dashed</source>
        <translation>Betrag: gemessen grau, Modell blau und gestrichelt</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PocketTable</name>
    <message>
        <source>Beyond what the speed override reaches</source>
        <translation>Außerhalb der Reichweite des Drehzahl-Overrides</translation>
    </message>
    <message>
        <source>(%1)</source>
        <translation>(%1)</translation>
    </message>
    <message>
        <source>best, rpm</source>
        <translation>beste, 1/min</translation>
    </message>
    <message>
        <source>down to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>&gt; %1</source>
        <translation>&gt; %1</translation>
    </message>
    <message>
        <source>No limit found: the search ended there</source>
        <translation>Keine Grenze gefunden: dort endete die Suche</translation>
    </message>
    <message>
        <source>stable, rpm</source>
        <translation>stabil, 1/min</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PresetBar</name>
    <message>
        <source>SAVE</source>
        <translation>SICHERN</translation>
    </message>
    <message>
        <source>DELETE</source>
        <translation>LÖSCHEN</translation>
    </message>
    <message>
        <source>GO TO</source>
        <translation>GEHE ZU</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>Choose a preset, or type a name and save what is on show</source>
        <translation>Eine Voreinstellung wählen, oder einen Namen eingeben und das Gezeigte sichern</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>14:03:20 or -12 s</source>
        <translation>14:03:20, -12 s</translation>
    </message>
    <message>
        <source>No cursor: click into a plot, with Shift for B</source>
        <translation>Kein Cursor: ins Bild klicken, mit Umschalt für B</translation>
    </message>
    <message>
        <source>Not a moment: write 14:03:20, or -12 for seconds ago</source>
        <translation>Kein Zeitpunkt: 14:03:20 schreiben, oder -12 für Sekunden zuvor</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>ZURÜCK</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::PresetList</name>
    <message>
        <source>Last 10 s</source>
        <translation>Letzte 10 s</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Ordnungen</translation>
    </message>
    <message>
        <source>Entry, 1 s</source>
        <translation>Eintritt, 1 s</translation>
    </message>
    <message>
        <source>2 min, max hold</source>
        <translation>2 min, Maximum</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::QuestionFields</name>
    <message>
        <source>Teeth</source>
        <translation>Zähne</translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation>Drehzahl, 1/min</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::RuleEditor</name>
    <message>
        <source>SPEED</source>
        <translation>DREHZAHL</translation>
    </message>
    <message>
        <source>Rules of the speed</source>
        <translation>Regeln der Drehzahl</translation>
    </message>
    <message>
        <source>FEED</source>
        <translation>VORSCHUB</translation>
    </message>
    <message>
        <source>Rules of the feed</source>
        <translation>Regeln des Vorschubs</translation>
    </message>
    <message>
        <source>Lower this rule</source>
        <translation>Diese Regel senken</translation>
    </message>
    <message>
        <source>Raise this rule</source>
        <translation>Diese Regel heben</translation>
    </message>
    <message>
        <source>Nothing has been learned</source>
        <translation>Es wurde nichts gelernt</translation>
    </message>
    <message>
        <source>Lessons: %1. No rule of this table has moved</source>
        <translation>Gelernt: %1-mal. Keine Regel dieser Tafel hat sich bewegt</translation>
    </message>
    <message>
        <source>Lessons: %1. Rules of this table that moved: %2, the furthest by %3</source>
        <translation>Gelernt: %1-mal. Bewegte Regeln dieser Tafel: %2, am weitesten um %3</translation>
    </message>
    <message>
        <source>These values cannot be used together: rules must fall as coherence rises, and the energy limit must be above its reference. Those before them still act</source>
        <translation>Diese Werte passen nicht zusammen: Regeln müssen mit steigender Kohärenz fallen, und die Energiegrenze muss über dem Energie-Sollwert liegen. Die vorherigen wirken weiter</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::RuleGrid</name>
    <message>
        <source>Rule table</source>
        <translation>Regeltafel</translation>
    </message>
    <message>
        <source>error %1, change %2: %3 (%4)</source>
        <translation>Fehler %1, Änderung %2: %3 (%4)</translation>
    </message>
    <message>
        <source>%1, learned %2</source>
        <translation>%1, gelernt %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SensitivityPanel</name>
    <message>
        <source>LESS SENSITIVE</source>
        <translation>UNEMPFINDLICHER</translation>
    </message>
    <message>
        <source>MORE SENSITIVE</source>
        <translation>EMPFINDLICHER</translation>
    </message>
    <message>
        <source>When it alarms: %1</source>
        <translation>Wann es Alarm gibt: %1</translation>
    </message>
    <message>
        <source>ENERGY RATIO: full chatter from the limit on</source>
        <translation>ENERGIEANTEIL: ab der Grenze volles Rattern</translation>
    </message>
    <message>
        <source>EVIDENCE OF GROWTH: an onset from the limit on</source>
        <translation>HINWEIS AUF WACHSTUM: ab der Grenze ein Beginn</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionList</name>
    <message>
        <source>Find job or tool</source>
        <translation>Auftrag oder Werkzeug suchen</translation>
    </message>
    <message>
        <source>JOB</source>
        <translation>JOB</translation>
    </message>
    <message>
        <source>Order by job</source>
        <translation>Nach Auftrag ordnen</translation>
    </message>
    <message>
        <source>TOOL</source>
        <translation>WKZ</translation>
    </message>
    <message>
        <source>Order by tool</source>
        <translation>Nach Werkzeug ordnen</translation>
    </message>
    <message>
        <source>TIME</source>
        <translation>ZEIT</translation>
    </message>
    <message>
        <source>Order by time</source>
        <translation>Nach Zeit ordnen</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>There are no recordings to work on here.</source>
        <translation>Hier gibt es keine Aufnahmen.</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>ECHT</translation>
    </message>
    <message>
        <source>Recordings of the folder</source>
        <translation>Aufnahmen des Ordners</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>Simulated cuts, replayed as recordings are</source>
        <translation>Simulierte Schnitte, wiedergegeben wie Aufnahmen</translation>
    </message>
    <message>
        <source>No recordings here. Cuts are recorded as the page SET UP, RECORDING says.</source>
        <translation>Hier sind keine Aufnahmen. Aufgenommen wird, wie es auf AUFBAU, AUFNAHME steht.</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>HISTORY</source>
        <translation>VERLAUF</translation>
    </message>
    <message>
        <source>Alarms by day, tool or job over all recordings</source>
        <translation>Alarme nach Tag, Werkzeug oder Job über alle Aufnahmen</translation>
    </message>
    <message>
        <source>recordings still to be read: %1</source>
        <translation>noch zu lesende Aufnahmen: %1</translation>
    </message>
    <message>
        <source>without alarms of their own, not counted: %1</source>
        <translation>ohne eigene Alarme, nicht gezählt: %1</translation>
    </message>
    <message>
        <source>No recording has this in its job, tool or date.</source>
        <translation>Keine Aufnahme hat das in Job, Werkzeug oder Datum.</translation>
    </message>
    <message>
        <source>not closed, still written or cut off, so not counted: %1</source>
        <translation>nicht abgeschlossen (wird noch geschrieben oder brach ab), darum nicht gezählt: %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionListModel</name>
    <message>
        <source>%1, tool %2, of %3</source>
        <translation>%1, Werkzeug %2, vom %3</translation>
    </message>
    <message>
        <source>%1, markers: %2</source>
        <translation>%1, Marken: %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionTimeline</name>
    <message>
        <source>Recording over time</source>
        <translation>Aufnahme über der Zeit</translation>
    </message>
    <message>
        <source>Choose a recording on the left</source>
        <translation>Links eine Aufnahme wählen</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>Schwingung</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SessionsPage</name>
    <message>
        <source>ON ALL PAGES</source>
        <translation>AUF ALLEN SEITEN</translation>
    </message>
    <message>
        <source>Show the replay on all pages</source>
        <translation>Die Wiedergabe auf allen Seiten zeigen</translation>
    </message>
    <message>
        <source>MARK</source>
        <translation>MARKE</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>COMPARE</source>
        <translation>VERGLEICH</translation>
    </message>
    <message>
        <source>Compare, score and export</source>
        <translation>Vergleichen, bewerten und ausgeben</translation>
    </message>
    <message>
        <source>ALL DETECTORS</source>
        <translation>ALLE PRÜFEN</translation>
    </message>
    <message>
        <source>Run every detector on this recording</source>
        <translation>Jeden Detektor über diese Aufnahme laufen lassen</translation>
    </message>
    <message>
        <source>SCORE</source>
        <translation>WERTEN</translation>
    </message>
    <message>
        <source>Score this recording against its markers</source>
        <translation>Diese Aufnahme gegen ihre Markierungen bewerten</translation>
    </message>
    <message>
        <source>SCORE ALL</source>
        <translation>ORDNER</translation>
    </message>
    <message>
        <source>Score the whole folder</source>
        <translation>Den ganzen Ordner bewerten</translation>
    </message>
    <message>
        <source>EXPORT</source>
        <translation>EXPORT</translation>
    </message>
    <message>
        <source>Export the selected span, or the whole</source>
        <translation>Gewählte Spanne oder alles ausgeben</translation>
    </message>
    <message>
        <source>REPORT</source>
        <translation>BERICHT</translation>
    </message>
    <message>
        <source>Write a report</source>
        <translation>Einen Bericht schreiben</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>HALT</translation>
    </message>
    <message>
        <source>Stop what is being worked on</source>
        <translation>Laufende Arbeit anhalten</translation>
    </message>
    <message>
        <source>FROM TUNE</source>
        <translation>VON WERTE</translation>
    </message>
    <message>
        <source>Take what was changed on the Tune page</source>
        <translation>Übernehmen, was auf der Seite Werte geändert wurde</translation>
    </message>
    <message>
        <source>What if: settings, KEY=VALUE, with spaces between them</source>
        <translation>Was wäre wenn: Einstellungen, SCHLÜSSEL=WERT, mit Leerzeichen dazwischen</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Was wäre, wenn</translation>
    </message>
    <message>
        <source>Every page shows the replay; the touches below still go to the machine</source>
        <translation>Jede Seite zeigt die Wiedergabe; die Tasten unten gelten weiter der Maschine</translation>
    </message>
    <message>
        <source>Every page shows the cut again</source>
        <translation>Jede Seite zeigt wieder den Schnitt</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>No recording is open</source>
        <translation>Keine Aufnahme ist offen</translation>
    </message>
    <message>
        <source>%1 · %2 · alarms: %3 · in chatter %4</source>
        <translation>%1 · %2 · Alarme: %3 · im Rattern %4</translation>
    </message>
    <message>
        <source>no verdict</source>
        <translation>kein Urteil</translation>
    </message>
    <message>
        <source>Drag over the picture or choose a marked span first: the loop repeats it</source>
        <translation>Erst über das Bild ziehen oder eine markierte Spanne wählen: die Schleife wiederholt sie</translation>
    </message>
    <message>
        <source>AS %1</source>
        <translation>ALS %1</translation>
    </message>
    <message>
        <source>The next format of EXPORT</source>
        <translation>Das nächste Format von AUSGABE</translation>
    </message>
    <message>
        <source>Not scored: %1</source>
        <translation>Nicht gewertet: %1</translation>
    </message>
    <message>
        <source>Keep this recording beside the next one that is opened</source>
        <translation>Diese Aufnahme neben der nächsten behalten, die geöffnet wird</translation>
    </message>
    <message>
        <source>Open another recording: this one stays beside it, as the dashed line</source>
        <translation>Eine andere Aufnahme öffnen: diese bleibt daneben, als gestrichelte Linie</translation>
    </message>
    <message>
        <source>OVERLAY</source>
        <translation>DANEBEN</translation>
    </message>
    <message>
        <source>WHOLE FILE</source>
        <translation>GANZE DATEI</translation>
    </message>
    <message>
        <source>Look at this recording as a whole, or open another file</source>
        <translation>Diese Aufnahme als Ganzes ansehen oder eine andere Datei öffnen</translation>
    </message>
    <message>
        <source>EVENTS</source>
        <translation>LOG</translation>
    </message>
    <message>
        <source>What happened in this recording</source>
        <translation>Was in dieser Aufnahme geschah</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SettingsForm</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>BROWSE</source>
        <translation>SUCHEN</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupDraft</name>
    <message>
        <source>no machine link is chosen: the program will only watch</source>
        <translation>keine Verbindung gewählt: das Programm schaut nur zu</translation>
    </message>
    <message>
        <source>no device is chosen</source>
        <translation>kein Gerät gewählt</translation>
    </message>
    <message>
        <source>the programmed speed is not known</source>
        <translation>die programmierte Drehzahl ist nicht bekannt</translation>
    </message>
    <message>
        <source>the number of flutes is not known</source>
        <translation>die Schneidenzahl ist nicht bekannt</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupFinder</name>
    <message>
        <source>Hosts to look at besides this computer</source>
        <translation>Rechner, die außer diesem abgesucht werden</translation>
    </message>
    <message>
        <source>FIND</source>
        <translation>SUCHEN</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Look for serial ports and machines, once</source>
        <translation>Einmal nach seriellen Anschlüssen und Maschinen suchen</translation>
    </message>
    <message>
        <source>USE</source>
        <translation>NEHMEN</translation>
    </message>
    <message>
        <source>Take the chosen one as the link</source>
        <translation>Den gewählten Eintrag als Verbindung nehmen</translation>
    </message>
    <message>
        <source>TEST THE LINK</source>
        <translation>VERBINDUNG PRÜFEN</translation>
    </message>
    <message>
        <source>Test the link step by step; nothing moves</source>
        <translation>Die Verbindung Schritt für Schritt prüfen; nichts bewegt sich</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>SICHERN</translation>
    </message>
    <message>
        <source>Save the link with its delay into the profile</source>
        <translation>Die Verbindung mit ihrer Verzögerung ins Profil speichern</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gesichert: %1</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>Suche läuft</translation>
    </message>
    <message>
        <source>Nothing answers. A path or a host can be typed on the left.</source>
        <translation>Nichts antwortet. Links lässt sich ein Pfad oder Rechner eintippen.</translation>
    </message>
    <message>
        <source>Nothing is looked for before you ask.</source>
        <translation>Gesucht wird erst, wenn Sie es verlangen.</translation>
    </message>
    <message>
        <source>FIND THE MACHINE</source>
        <translation>MASCHINE SUCHEN</translation>
    </message>
    <message>
        <source>more hosts, or 192.168.1.0/24</source>
        <translation>weitere Rechner, oder 192.168.1.0/24</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupGuide</name>
    <message>
        <source>SHOW ME A SIMULATED CUT</source>
        <translation>SIMULIERTEN SCHNITT ZEIGEN</translation>
    </message>
    <message>
        <source>Or connect this machine, step by step. Each step says what is still missing; nothing is commanded while authority is Off.</source>
        <translation>Oder diese Maschine Schritt für Schritt anschließen. Jeder Schritt sagt, was noch fehlt; nichts wird befohlen, solange AUS gewählt ist.</translation>
    </message>
    <message>
        <source>1  MACHINE</source>
        <translation>1  MASCHINE</translation>
    </message>
    <message>
        <source>2  SENSORS</source>
        <translation>2  SENSOREN</translation>
    </message>
    <message>
        <source>3  TOOL</source>
        <translation>3  WERKZEUG</translation>
    </message>
    <message>
        <source>4  TRY OUT, SAVE, START</source>
        <translation>4  PRÜFEN, STARTEN</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>still open</source>
        <translation>noch offen</translation>
    </message>
    <message>
        <source>Look at a simulated cut first: it chatters as it gets deeper, and the program finds the stable speed. Nothing has to be connected.</source>
        <translation>Zuerst einen simulierten Schnitt ansehen: er rattert, wenn er tiefer wird, und das Programm findet die stabile Drehzahl. Nichts muss angeschlossen sein.</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>Three ways to begin</source>
        <translation>Drei Wege zum Anfang</translation>
    </message>
    <message>
        <source>LOOK AT MY RECORDING</source>
        <translation>MEINE AUFNAHME ANSEHEN</translation>
    </message>
    <message>
        <source>Or open a recording of a cut, of a phone or a logger: whether it chatters, why, and which speed helps.</source>
        <translation>Oder eine Aufnahme eines Schnitts öffnen, vom Telefon oder Datenlogger: ob sie rattert, warum, und welche Drehzahl hilft.</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupLimits</name>
    <message>
        <source>STILLCUT NEVER DRIVES THE MACHINE BEYOND</source>
        <translation>DARÜBER FÄHRT STILLCUT DIE MASCHINE NIE HINAUS</translation>
    </message>
    <message>
        <source>What the program says and the operator&apos;s own overrides are left alone. The limits are saved with the profile and hold from its START on, for the whole run.</source>
        <translation>Was das Programm sagt und die eigenen Overrides des Bedieners bleiben, wie sie sind. Die Grenzen werden mit dem Profil gesichert und gelten ab dessen START für den ganzen Lauf.</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupMachine</name>
    <message>
        <source>Name of the machine</source>
        <translation>Name der Maschine</translation>
    </message>
    <message>
        <source>Programmed speed in rpm</source>
        <translation>Programmierte Drehzahl in 1/min</translation>
    </message>
    <message>
        <source>AUTO MAY BE CHOSEN</source>
        <translation>AUTOMATIK WÄHLBAR</translation>
    </message>
    <message>
        <source>Auto may be chosen on this machine</source>
        <translation>Auto darf an dieser Maschine gewählt werden</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation>Drehzahl, 1/min</translation>
    </message>
    <message>
        <source>LINK TO THE CONTROL</source>
        <translation>VERBINDUNG ZUR STEUERUNG</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>Programmierter Vorschub</translation>
    </message>
    <message>
        <source>Feed, %1</source>
        <translation>Vorschub, %1</translation>
    </message>
    <message>
        <source>Programmed feed in %1</source>
        <translation>Programmierter Vorschub in %1</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>Schnitttiefe</translation>
    </message>
    <message>
        <source>The depth was not taken: it must be a number from %1 to %2, or nothing where it is not known</source>
        <translation>Die Tiefe wurde nicht übernommen: nötig ist eine Zahl von %1 bis %2, oder nichts, wenn sie nicht bekannt ist</translation>
    </message>
    <message>
        <source>Depth, %1</source>
        <translation>Tiefe, %1</translation>
    </message>
    <message>
        <source>Depth of cut in %1</source>
        <translation>Schnitttiefe in %1</translation>
    </message>
    <message>
        <source>Deepest cut of the programme, %1 to %2; the Lobes page shows the cut at this depth</source>
        <translation>Tiefster Schnitt des Programms, %1 bis %2; die Seite Stabilität zeigt den Schnitt in dieser Tiefe</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupPage</name>
    <message>
        <source>There is nothing to set up here.</source>
        <translation>Hier gibt es nichts einzurichten.</translation>
    </message>
    <message>
        <source>GUIDE</source>
        <translation>ANLEITUNG</translation>
    </message>
    <message>
        <source>MACHINE</source>
        <translation>MASCHINE</translation>
    </message>
    <message>
        <source>SENSORS</source>
        <translation>SENSOREN</translation>
    </message>
    <message>
        <source>TOOLS</source>
        <translation>WERKZEUGE</translation>
    </message>
    <message>
        <source>PROFILE</source>
        <translation>PROFIL</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>AUFNAHME</translation>
    </message>
    <message>
        <source>LIMITS</source>
        <translation>GRENZEN</translation>
    </message>
    <message>
        <source>START</source>
        <translation>START</translation>
    </message>
    <message>
        <source>Save what was changed and begin with it</source>
        <translation>Geändertes speichern und damit beginnen</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupProfile</name>
    <message>
        <source>Name of the profile</source>
        <translation>Name des Profils</translation>
    </message>
    <message>
        <source>TRY OUT</source>
        <translation>PRÜFEN</translation>
    </message>
    <message>
        <source>Try out step by step; nothing is commanded</source>
        <translation>Schritt für Schritt prüfen; nichts wird befohlen</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>SICHERN</translation>
    </message>
    <message>
        <source>Save the profile</source>
        <translation>Profil sichern</translation>
    </message>
    <message>
        <source>START</source>
        <translation>START</translation>
    </message>
    <message>
        <source>LOAD</source>
        <translation>LADEN</translation>
    </message>
    <message>
        <source>Load the chosen profile</source>
        <translation>Gewähltes Profil laden</translation>
    </message>
    <message>
        <source>PROFILES</source>
        <translation>PROFILE</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>DETECTOR IN CHARGE</source>
        <translation>FÜHRENDER DETEKTOR</translation>
    </message>
    <message>
        <source>STRATEGY</source>
        <translation>STRATEGIE</translation>
    </message>
    <message>
        <source>Save the profile and begin with it</source>
        <translation>Profil sichern und damit beginnen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gesichert: %1</translation>
    </message>
    <message>
        <source>It runs. Authority is Off.</source>
        <translation>Es läuft. Befugnis ist Aus.</translation>
    </message>
    <message>
        <source>Loaded: %1</source>
        <translation>Geladen: %1</translation>
    </message>
    <message>
        <source>A demonstration runs, no profile.</source>
        <translation>Eine Vorführung läuft, kein Profil.</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>In Kraft: %1</translation>
    </message>
    <message>
        <source>Try it out first: each step says what was found. Nothing is commanded.</source>
        <translation>Zuerst prüfen: jeder Schritt sagt, was gefunden wurde. Nichts wird befohlen.</translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation>Beispiel: %1</translation>
    </message>
    <message>
        <source>No device is chosen to measure with: choose one under SENSORS.</source>
        <translation>Es ist kein Gerät zum Messen gewählt: unter SENSOREN eines wählen.</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupRecording</name>
    <message>
        <source>Who is at the machine</source>
        <translation>Wer an der Maschine ist</translation>
    </message>
    <message>
        <source>Job: what is being made</source>
        <translation>Auftrag: was gemacht wird</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>RECORD EVERY CUT</source>
        <translation>JEDEN SCHNITT AUFNEHMEN</translation>
    </message>
    <message>
        <source>Record every cut of this machine</source>
        <translation>Jeden Schnitt dieser Maschine aufnehmen</translation>
    </message>
    <message>
        <source>WHAT RUNS NOW</source>
        <translation>WAS JETZT LÄUFT</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>WHAT IS KEPT</source>
        <translation>WAS BLEIBT</translation>
    </message>
    <message>
        <source>nothing is recorded</source>
        <translation>nichts wird aufgenommen</translation>
    </message>
    <message>
        <source>Every sample, from the beginning of the cut to its end.</source>
        <translation>Jeder Messwert, vom Anfang des Schnitts bis zum Ende.</translation>
    </message>
    <message>
        <source>What surrounds alarms, faults and touches; the time before is held in memory until then.</source>
        <translation>Was um Alarme, Störungen und Tastendrücke liegt; die Zeit davor wird bis dahin im Speicher gehalten.</translation>
    </message>
    <message>
        <source>Verdicts and indicators without samples, as a history.</source>
        <translation>Urteile und Kennwerte ohne Messwerte, als Verlauf.</translation>
    </message>
    <message>
        <source>job</source>
        <translation>auftrag</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>werkzeug</translation>
    </message>
    <message>
        <source>Files are named by job, tool and time: %1</source>
        <translation>Dateien heißen nach Auftrag, Werkzeug und Zeit: %1</translation>
    </message>
    <message>
        <source>Nothing is recorded. What is chosen here begins with START on the page PROFILE.</source>
        <translation>Nichts wird aufgenommen. Was hier gewählt ist, gilt ab STARTEN auf der Seite PROFIL.</translation>
    </message>
    <message>
        <source>Recording begins with the next event, and with what was before it.</source>
        <translation>Die Aufnahme beginnt mit dem nächsten Ereignis und dem, was davor war.</translation>
    </message>
    <message>
        <source>Writes %1</source>
        <translation>Schreibt %1</translation>
    </message>
    <message>
        <source>Recording has stopped; what was recorded is in %1</source>
        <translation>Die Aufnahme ist stehen geblieben; was aufgenommen wurde, ist in %1</translation>
    </message>
    <message>
        <source>Deleted because of the limits: %1, the last one %2</source>
        <translation>Wegen der Grenzen gelöscht: %1, zuletzt %2</translation>
    </message>
    <message>
        <source>Too old or too large, but could not be deleted: %1. Free the room by hand: %2</source>
        <translation>Zu alt oder zu groß, konnten aber nicht gelöscht werden: %1. Bitte von Hand Platz schaffen: %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupSensorTrial</name>
    <message>
        <source>Level of the calibrator, as 94 dB, 1 g or 10</source>
        <translation>Pegel des Kalibrators, etwa 94 dB, 1 g oder 10</translation>
    </message>
    <message>
        <source>Frequency of the calibrator in Hz</source>
        <translation>Frequenz des Kalibrators in Hz</translation>
    </message>
    <message>
        <source>CALIBRATE</source>
        <translation>KALIBRIEREN</translation>
    </message>
    <message>
        <source>Hear the calibrator on the chosen channel</source>
        <translation>Den Kalibrator auf dem gewählten Kanal anhören</translation>
    </message>
    <message>
        <source>KNOCK</source>
        <translation>KLOPFEN</translation>
    </message>
    <message>
        <source>Hear knocks along the axis of the chosen channel</source>
        <translation>Schläge entlang der Achse des gewählten Kanals hören</translation>
    </message>
    <message>
        <source>Calibrator</source>
        <translation>Kalibrator</translation>
    </message>
    <message>
        <source>Is it this sensor that lies along its axis?</source>
        <translation>Liegt dieser Sensor wirklich entlang seiner Achse?</translation>
    </message>
    <message>
        <source>The frequency is no number above 0.</source>
        <translation>Die Frequenz ist keine Zahl über 0.</translation>
    </message>
    <message>
        <source>Listening to the calibrator</source>
        <translation>Der Kalibrator wird angehört</translation>
    </message>
    <message>
        <source>Knock along the axis now, a few times</source>
        <translation>Jetzt einige Male entlang der Achse klopfen</translation>
    </message>
    <message>
        <source>Knock along %1 now, a few times, near the sensor</source>
        <translation>Jetzt einige Male entlang %1 klopfen, nahe am Sensor</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupSensors</name>
    <message>
        <source>DEVICE</source>
        <translation>GERÄT</translation>
    </message>
    <message>
        <source>CHANNELS</source>
        <translation>KANÄLE</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>ADD CHANNEL</source>
        <translation>KANAL DAZU</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Einen Kanal hinzufügen</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>ENTFERNEN</translation>
    </message>
    <message>
        <source>Remove the chosen channel</source>
        <translation>Gewählten Kanal entfernen</translation>
    </message>
    <message>
        <source>WHAT RUNS NOW</source>
        <translation>WAS JETZT LÄUFT</translation>
    </message>
    <message>
        <source>LISTEN</source>
        <translation>HÖREN</translation>
    </message>
    <message>
        <source>Listen to the chosen device</source>
        <translation>Das gewählte Gerät anhören</translation>
    </message>
    <message>
        <source>THE CHOSEN DEVICE</source>
        <translation>DAS GEWÄHLTE GERÄT</translation>
    </message>
    <message>
        <source>Opening the device</source>
        <translation>Das Gerät wird geöffnet</translation>
    </message>
    <message>
        <source>Take %1, which is plugged in here</source>
        <translation>%1 nehmen, das hier angesteckt ist</translation>
    </message>
    <message>
        <source>Nothing is plugged in that could be heard. Plug in a microphone or a sensor: it shows here by its name.</source>
        <translation>Nichts ist angeschlossen, das zu hören wäre. Mikrofon oder Sensor anstecken: Es erscheint hier mit seinem Namen.</translation>
    </message>
    <message>
        <source>OTHER DEVICE</source>
        <translation>ANDERES GERÄT</translation>
    </message>
    <message>
        <source>Other kinds of devices: recordings, measuring cards, boards, networks</source>
        <translation>Andere Arten von Geräten: Aufnahmen, Messkarten, Platinen, Netze</translation>
    </message>
    <message>
        <source>THREE THAT WORK, AND HOW</source>
        <translation>DREI, DIE GEHEN, UND WIE</translation>
    </message>
    <message>
        <source>MICROPHONE</source>
        <translation>MIKROFON</translation>
    </message>
    <message>
        <source>Measurement microphone, USB sound card</source>
        <translation>Messmikrofon, USB-Soundkarte</translation>
    </message>
    <message>
        <source>IEPE SENSOR</source>
        <translation>IEPE</translation>
    </message>
    <message>
        <source>IEPE accelerometer, USB interface</source>
        <translation>IEPE-Beschleunigungssensor, USB-Wandler</translation>
    </message>
    <message>
        <source>MEMS BOARD</source>
        <translation>MEMS</translation>
    </message>
    <message>
        <source>MEMS board on USB, two axes</source>
        <translation>MEMS-Platine an USB, zwei Achsen</translation>
    </message>
    <message>
        <source>The manual on it: %1</source>
        <translation>Das Handbuch dazu: %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SetupTools</name>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Holder and stick-out</source>
        <translation>Halter, Auskragung</translation>
    </message>
    <message>
        <source>Pitch angles, degrees</source>
        <translation>Teilung, Grad</translation>
    </message>
    <message>
        <source>File of its modes</source>
        <translation>Datei der Moden</translation>
    </message>
    <message>
        <source>Highest speed, rpm</source>
        <translation>Höchstdrehzahl, 1/min</translation>
    </message>
    <message>
        <source>KEEP</source>
        <translation>BEHALTEN</translation>
    </message>
    <message>
        <source>Keep this tool</source>
        <translation>Dieses Werkzeug behalten</translation>
    </message>
    <message>
        <source>USE IT</source>
        <translation>NUTZEN</translation>
    </message>
    <message>
        <source>Use this tool for the profile</source>
        <translation>Dieses Werkzeug für das Profil nutzen</translation>
    </message>
    <message>
        <source>REMOVE</source>
        <translation>ENTFERNEN</translation>
    </message>
    <message>
        <source>Remove this tool</source>
        <translation>Dieses Werkzeug entfernen</translation>
    </message>
    <message>
        <source>CHATTERED HERE</source>
        <translation>RATTERT HIER</translation>
    </message>
    <message>
        <source>Note that it chatters now</source>
        <translation>Vermerken, dass es jetzt rattert</translation>
    </message>
    <message>
        <source>NEW TOOL</source>
        <translation>NEUES WERKZEUG</translation>
    </message>
    <message>
        <source>New tool</source>
        <translation>Neues Werkzeug</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>even</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>The profile uses it now</source>
        <translation>Das Profil nutzt es jetzt</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Entfernt</translation>
    </message>
    <message>
        <source>Chattered at %1 rpm, %2 Hz  %3</source>
        <translation>Ratterte bei %1 1/min, %2 Hz  %3</translation>
    </message>
    <message>
        <source>No tools yet: begin with NEW TOOL</source>
        <translation>Noch keine Werkzeuge: mit NEUES WERKZEUG beginnen</translation>
    </message>
    <message>
        <source>Noted</source>
        <translation>Vermerkt</translation>
    </message>
    <message>
        <source>Not kept: the pitch needs one angle per tooth, 360 degrees together</source>
        <translation>Nicht behalten: Die Teilung braucht einen Winkel je Zahn, zusammen 360 Grad</translation>
    </message>
    <message>
        <source>PUT IT BACK</source>
        <translation>ZURÜCKHOLEN</translation>
    </message>
    <message>
        <source>Put the removed tool back</source>
        <translation>Das entfernte Werkzeug zurückholen</translation>
    </message>
    <message>
        <source>It is back</source>
        <translation>Es ist wieder da</translation>
    </message>
    <message>
        <source>Not kept yet</source>
        <translation>Noch nicht behalten</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schneidet</translation>
    </message>
    <message>
        <source>File of its response</source>
        <translation>Datei der Antwort</translation>
    </message>
    <message>
        <source>Stick-out</source>
        <translation>Auskraglänge</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>Größte Zustellung</translation>
    </message>
    <message>
        <source>Lowest speed, rpm</source>
        <translation>Niedrigste Drehzahl, 1/min</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Not used: %1</source>
        <translation>Nicht benutzt: %1</translation>
    </message>
    <message>
        <source>modes: %1</source>
        <translation>Moden: %1</translation>
    </message>
    <message>
        <source>response: %1</source>
        <translation>Antwort: %1</translation>
    </message>
    <message>
        <source>Not kept: the lowest speed lies above the highest</source>
        <translation>Nicht behalten: die niedrigste Drehzahl liegt über der höchsten</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>Nicht behalten: %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SpectraMap</name>
    <message>
        <source>SPECTROGRAM</source>
        <translation>SPEKTROGRAMM</translation>
    </message>
    <message>
        <source>Drag: move. Wheel: zoom in time, with Ctrl in frequency. Ctrl and drag: zoom to a stretch. Double click: all. Click: cursor A, with Shift B.</source>
        <translation>Ziehen: verschieben. Rad: Zeit zoomen, mit Strg die Frequenz. Strg und Ziehen: auf einen Abschnitt zoomen. Doppelklick: alles. Klick: Cursor A, mit Umschalt B.</translation>
    </message>
    <message>
        <source>order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>Rattern %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::SpectrogramWidget</name>
    <message>
        <source>Spectrogram of the last ten seconds</source>
        <translation>Spektrogramm der letzten zehn Sekunden</translation>
    </message>
    <message>
        <source>X: axis in Hz, orders or rpm. Page Up, Page Down: reach of the axis.</source>
        <translation>X: Achse in Hz, Ordnungen oder 1/min. Bild auf, Bild ab: Reichweite der Achse.</translation>
    </message>
    <message>
        <source>no chatter</source>
        <translation>kein Rattern</translation>
    </message>
    <message>
        <source>chatter at %1</source>
        <translation>Rattern bei %1</translation>
    </message>
    <message>
        <source>SPECTROGRAM</source>
        <translation>SPEKTROGRAMM</translation>
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
        <translation>%1, letzte 10 s</translation>
    </message>
    <message>
        <source>STALE: nothing new arrives</source>
        <translation>VERALTET: nichts Neues kommt an</translation>
    </message>
    <message>
        <source>Waiting for the first samples</source>
        <translation>Wartet auf die ersten Messwerte</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>1× tooth</source>
        <translation>1× Zahn</translation>
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
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom.</source>
        <translation>Klick: Harmonischen-Cursor. H: auf die stärkste Linie. Ziehen: verschieben. Rad: zoomen.</translation>
    </message>
    <message>
        <source>SPECTRUM</source>
        <translation>SPEKTRUM</translation>
    </message>
    <message>
        <source>SPECTRUM AT A, %1</source>
        <translation>SPEKTRUM BEI A, %1</translation>
    </message>
    <message>
        <source>SPECTRUM, NEWEST</source>
        <translation>SPEKTRUM, NEUESTES</translation>
    </message>
    <message>
        <source>cursor: %1</source>
        <translation>Cursor: %1</translation>
    </message>
    <message>
        <source>order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>chatter %1</source>
        <translation>Rattern %1</translation>
    </message>
    <message>
        <source>SPECTRUM, STALE: nothing new arrives</source>
        <translation>SPEKTRUM, VERALTET: nichts Neues</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::StateRows</name>
    <message>
        <source>STATES</source>
        <translation>ZUSTÄNDE</translation>
    </message>
    <message>
        <source>low: stable, half: onset, full: chatter, hatched: not judged; line: first indicator</source>
        <translation>niedrig: stabil, halb: Beginn, voll: Rattern, schraffiert: nicht beurteilt; Linie: erste Kenngröße</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::StatusStrip</name>
    <message>
        <source>State of the chain</source>
        <translation>Zustand der Kette</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapLobePlot</name>
    <message>
        <source>Depth limits over speed</source>
        <translation>Grenzen der Tiefe über der Drehzahl</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Rechnet</translation>
    </message>
    <message>
        <source>Here the limits of the depth appear.</source>
        <translation>Hier erscheinen die Grenzen der Tiefe.</translation>
    </message>
    <message>
        <source>Speeds to try; their depth is not known</source>
        <translation>Drehzahlen zum Versuchen; ihre Tiefe ist nicht bekannt</translation>
    </message>
    <message>
        <source>Depth limit, hatched its uncertainty, blue what is recommended</source>
        <translation>Grenze der Tiefe, schraffiert ihre Unsicherheit, blau der Rat</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapMeasure</name>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Hammer</source>
        <translation>Hammer</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>BEGIN</source>
        <translation>BEGINNEN</translation>
    </message>
    <message>
        <source>Begin the hits of this axis anew</source>
        <translation>Die Schläge dieser Achse neu beginnen</translation>
    </message>
    <message>
        <source>FILES</source>
        <translation>DATEIEN</translation>
    </message>
    <message>
        <source>Open files of a tap test</source>
        <translation>Dateien eines Klopfversuchs öffnen</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>Schläge</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Files of a tap test</source>
        <translation>Dateien eines Klopfversuchs</translation>
    </message>
    <message>
        <source>SENSOR OPPOSITE</source>
        <translation>SENSOR GEGENÜBER</translation>
    </message>
    <message>
        <source>The sensor sits on the other side: turn the response</source>
        <translation>Der Sensor sitzt auf der anderen Seite: die Antwort umkehren</translation>
    </message>
    <message>
        <source>READ</source>
        <translation>LESEN</translation>
    </message>
    <message>
        <source>Read the files again with what was said</source>
        <translation>Die Dateien mit den Angaben noch einmal lesen</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapModes</name>
    <message>
        <source>Modes</source>
        <translation>Moden</translation>
    </message>
    <message>
        <source>Name of the file of modes</source>
        <translation>Name der Datei der Moden</translation>
    </message>
    <message>
        <source>KEEP</source>
        <translation>BEHALTEN</translation>
    </message>
    <message>
        <source>Keep the ticked modes of both axes in a file</source>
        <translation>Die angehakten Moden beider Achsen in einer Datei behalten</translation>
    </message>
    <message>
        <source>Keep as</source>
        <translation>Behalten als</translation>
    </message>
    <message>
        <source>Kept; a tool takes it as the file of its modes: %1</source>
        <translation>Behalten; ein Werkzeug nimmt es als Datei seiner Moden: %1</translation>
    </message>
    <message>
        <source>Not measured along %1</source>
        <translation>Längs %1 nicht gemessen</translation>
    </message>
    <message>
        <source>Fitting the modes</source>
        <translation>Moden werden angepasst</translation>
    </message>
    <message>
        <source>A touch ticks a mode. Only ticked ones count.</source>
        <translation>Ein Tipp hakt eine Mode an. Nur angehakte zählen.</translation>
    </message>
    <message>
        <source>No force was measured: how stiff a mode is cannot be told.</source>
        <translation>Keine Kraft gemessen: wie steif eine Mode ist, lässt sich nicht sagen.</translation>
    </message>
    <message>
        <source>%1 Hz: %2</source>
        <translation>%1 Hz: %2</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapPage</name>
    <message>
        <source>There is nothing to measure with here.</source>
        <translation>Hier gibt es nichts zum Messen.</translation>
    </message>
    <message>
        <source>1 HIT</source>
        <translation>1 KLOPFEN</translation>
    </message>
    <message>
        <source>2 MODES</source>
        <translation>2 MODEN</translation>
    </message>
    <message>
        <source>3 SPEED</source>
        <translation>3 DREHZAHL</translation>
    </message>
    <message>
        <source>Axis x, along the feed</source>
        <translation>Achse x, in Vorschubrichtung</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>Achse y</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapPart</name>
    <message>
        <source>KEEP?</source>
        <translation>BEHALTEN?</translation>
    </message>
    <message>
        <source>%1 is there already. Touch KEEP again to overwrite it, or give another name.</source>
        <translation>%1 gibt es schon. BEHALTEN noch einmal berühren, um sie zu überschreiben, oder einen anderen Namen geben.</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TapSpeeds</name>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Climb or conventional</source>
        <translation>Gleichlauf oder Gegenlauf</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Zähne</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Width of cut</source>
        <translation>Eingriffsbreite</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>Vorschub je Zahn</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>Kleinste Drehzahl</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Größte Drehzahl</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>Größte Zustellung</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>KEEP</source>
        <translation>BEHALTEN</translation>
    </message>
    <message>
        <source>Keep modes and cut for this tool</source>
        <translation>Moden und Schnitt für dieses Werkzeug behalten</translation>
    </message>
    <message>
        <source>Keep for</source>
        <translation>Behalten für</translation>
    </message>
    <message>
        <source>Kept: %1</source>
        <translation>Behalten: %1</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>Gegenlauf</translation>
    </message>
    <message>
        <source>a file alone</source>
        <translation>nur als Datei</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TimePlot</name>
    <message>
        <source>STALE: nothing new arrives</source>
        <translation>VERALTET: nichts Neues kommt an</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TimingFields</name>
    <message>
        <source>READ</source>
        <translation>LESEN</translation>
    </message>
    <message>
        <source>Read the recording with so many samples a second</source>
        <translation>Die Aufzeichnung mit so vielen Messwerten je Sekunde lesen</translation>
    </message>
    <message>
        <source>Samples a second</source>
        <translation>Messwerte je Sekunde</translation>
    </message>
    <message>
        <source>Its times are in %1</source>
        <translation>Die Zeiten sind in %1</translation>
    </message>
    <message>
        <source>In what are its times?</source>
        <translation>In welcher Einheit sind die Zeiten?</translation>
    </message>
    <message>
        <source>Samples a second, Hz</source>
        <translation>Messwerte je Sekunde, Hz</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::ToolModel</name>
    <message>
        <source>chattered here before: %1</source>
        <translation>ratterte schon: %1</translation>
    </message>
    <message>
        <source>D %1, %2 flutes</source>
        <translation>D %1, %2 Schneiden</translation>
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
        <translation>Von diesem Abschnitt sind keine Werte aufgehoben</translation>
    </message>
    <message>
        <source>peak %1</source>
        <translation>Spitze %1</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TrackPlot</name>
    <message>
        <source>DETECTORS</source>
        <translation>DETEKTOREN</translation>
    </message>
    <message>
        <source>Low: stable. Half: onset. Full: chatter. Hatched: no verdict. The line is the first indicator.</source>
        <translation>Niedrig: stabil. Halb: Beginn. Voll: Rattern. Schraffiert: kein Urteil. Die Linie ist die erste Kenngröße.</translation>
    </message>
    <message>
        <source>low: stable, half: onset, full: chatter; line: first indicator</source>
        <translation>tief: stabil, halb: Beginn, voll: Rattern; Linie: erste Kenngröße</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TransportBar</name>
    <message>
        <source>To the beginning</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>A block back</source>
        <translation>Einen Block zurück</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>START</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>A block on</source>
        <translation>Einen Block weiter</translation>
    </message>
    <message>
        <source>LOOP</source>
        <translation>LOOP</translation>
    </message>
    <message>
        <source>Repeat the selected span</source>
        <translation>Gewählte Spanne wiederholen</translation>
    </message>
    <message>
        <source>Pace of the replay</source>
        <translation>Tempo der Wiedergabe</translation>
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
        <translation>schnellstens</translation>
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
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>UNDO</source>
        <translation>ZURÜCK</translation>
    </message>
    <message>
        <source>REDO</source>
        <translation>WIEDER</translation>
    </message>
    <message>
        <source>DEFAULTS</source>
        <translation>VORGABEN</translation>
    </message>
    <message>
        <source>SAVE</source>
        <translation>SICHERN</translation>
    </message>
    <message>
        <source>WHAT IT SEES NOW</source>
        <translation>WAS ES JETZT SIEHT</translation>
    </message>
    <message>
        <source>COMPARE</source>
        <translation>VERGLEICH</translation>
    </message>
    <message>
        <source>A = B</source>
        <translation>A = B</translation>
    </message>
    <message>
        <source>Use the values of side A</source>
        <translation>Werte der Seite A nutzen</translation>
    </message>
    <message>
        <source>Use the values of side B</source>
        <translation>Werte der Seite B nutzen</translation>
    </message>
    <message>
        <source>Make the other side like this one</source>
        <translation>Die andere Seite wie diese machen</translation>
    </message>
    <message>
        <source>Nothing to tune: this session has no methods of its own</source>
        <translation>Nichts einzustellen: diese Sitzung hat keine eigenen Verfahren</translation>
    </message>
    <message>
        <source>B = A</source>
        <translation>B = A</translation>
    </message>
    <message>
        <source>Both sides are alike. Take B, change something, and go to and fro.</source>
        <translation>Beide Seiten sind gleich. B nehmen, etwas ändern, und hin und her wechseln.</translation>
    </message>
    <message>
        <source>Values that differ: %1</source>
        <translation>Verschiedene Werte: %1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>It does not run</source>
        <translation>Es läuft nicht</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Behalten in %1</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>Nicht behalten: %1</translation>
    </message>
    <message>
        <source>The picture is stale: nothing new for %1</source>
        <translation>Das Bild ist veraltet: seit %1 nichts Neues</translation>
    </message>
    <message>
        <source>The replay is paused</source>
        <translation>Die Wiedergabe ist angehalten</translation>
    </message>
    <message>
        <source>Learned by itself</source>
        <translation>Selbst gelernt</translation>
    </message>
    <message>
        <source>REVERT</source>
        <translation>VERWERFEN</translation>
    </message>
    <message>
        <source>EXPERT</source>
        <translation>EXPERTE</translation>
    </message>
    <message>
        <source>Expert: every method and each of its parameters</source>
        <translation>Experte: jedes Verfahren und jeder seiner Parameter</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::TuningController</name>
    <message>
        <source>to the defaults</source>
        <translation>auf die Vorgaben</translation>
    </message>
    <message>
        <source>as the run began</source>
        <translation>wie zu Beginn</translation>
    </message>
    <message>
        <source>both sides alike</source>
        <translation>beide Seiten gleich</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::VerdictSign</name>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>stillcut::ui::WavePlot</name>
    <message>
        <source>SIGNAL</source>
        <translation>SIGNAL</translation>
    </message>
    <message>
        <source>Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Double click: all. Click: cursor A, with Shift B.</source>
        <translation>Ziehen: verschieben. Rad: zoomen. Strg und Ziehen: auf einen Abschnitt zoomen. Doppelklick: alles. Klick: Cursor A, mit Umschalt B.</translation>
    </message>
    <message>
        <source>below: %1</source>
        <translation>unten: %1</translation>
    </message>
</context>
</TS>
