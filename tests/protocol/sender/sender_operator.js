// The operator at CNCjs: signs in, opens the serial port there and stays.
// Usage: sender_operator.js MODULES PORT DEVICE; MODULES is the node_modules that CNCjs was installed into.
const http = require('http');
const [modules, port, device] = process.argv.slice(2);
const io = require(modules + '/socket.io-client');
const request = http.request(
    {host: '127.0.0.1', port, path: '/api/signin', method: 'POST', headers: {'Content-Type': 'application/json'}},
    (answer) => {
      let body = '';
      answer.on('data', (part) => body += part);
      answer.on('end', () => {
        const token = JSON.parse(body).token;
        const socket = io('http://127.0.0.1:' + port, {query: 'token=' + token, transports: ['websocket']});
        socket.on('connect', () => socket.emit('open', device, {controllerType: 'Grbl', baudrate: 115200}));
      });
    });
request.on('error', () => process.exit(1));
request.end('{}');
