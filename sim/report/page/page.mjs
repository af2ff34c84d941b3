// SPDX-License-Identifier: Apache-2.0
// page.mjs: the page that a command wrote: of one frame, or of a study.
import {data} from './data.mjs';
import {frame_page} from './frame/frame.mjs';
import {study_page} from './study.mjs';

const kinds = {frame: frame_page, study: study_page};

document.title = data.title;
const main = document.getElementById('page');
main.replaceChildren();
kinds[data.kind](main, data).then(() => {
  document.documentElement.dataset.opened = Math.round(performance.now());  // ms since the page was asked for
  document.documentElement.dataset.ready = 'yes';
});
