function answer = read_answers(recording, options)
% The answer of `stillcut-cli analyze` and its series, in MATLAB (R2016b and later) and GNU Octave (7 and later):
%   answer = read_answers('cut.wav', '--teeth 4 --speed 8800');
  series = [tempname() '.csv'];
  [code, text] = system(['stillcut-cli analyze ' recording ' ' options ' --json --series ' series]);
  if code > 1  % 0: no chatter, 1: chatter
    error('read_answers:analyze', 'stillcut-cli ended with %d: %s', code, text);  % why stands on the screen
  end
  whole = jsondecode(text);
  assert(strcmp(whole.schema, 'stillcut-cli/1'));
  answer = whole.answer;
  fprintf('%s\n', answer.sentence);

  file = fopen(series, 'r');
  names = strsplit(strtrim(fgetl(file)), ',');
  rows = textscan(file, repmat('%s', 1, numel(names)), 'Delimiter', ',');
  fclose(file);
  delete(series);
  column = @(name) rows{strcmp(names, name)};
  t = str2double(column('t'));
  valid = strcmp(column([answer.detector '.valid']), '1');  % what is not valid was not judged
  state = column([answer.detector '.state']);
  alarm = valid & (strcmp(state, 'onset') | strcmp(state, 'chatter'));
  step = median(diff(t));
  fprintf('judged %.2f s of %.2f s, in alarm %.2f s\n', step * sum(valid), t(end), step * sum(alarm));
end
