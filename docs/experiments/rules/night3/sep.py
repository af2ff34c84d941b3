import numpy as np, sys
sys.path.insert(0,'/work/w/h4/docs/experiments/rules')
from rules import Scene
allr=[]
for n in sys.argv[1:]:
    s=Scene(n)
    for i,w in enumerate(s.walks):
        if w[1]!='W': continue
        allr.append((n[:4],w[0],[float(s.peak[k][i]) for k in 'raAgwc']))
allr.sort(key=lambda t:-t[2][0])
print('scene win  r   a   A   g   w   c')
for t in allr[:60]: print(t[0],t[1],*['%7d'%v for v in t[2]])
# separation: for each kind, threshold that catches all with r>5632: how many false positives
for j,k in enumerate('raAgwc'):
    for lim in (5632,8000):
        th=min(t[2][j] for t in allr if t[2][0]>lim)
        print(k,lim,'cap',int(th),'needed',sum(t[2][0]>lim for t in allr),'split',sum(t[2][j]>=th for t in allr), {n[:4]:sum(t[2][j]>=th and t[0]==n[:4] for t in allr) for n in sys.argv[1:]})
