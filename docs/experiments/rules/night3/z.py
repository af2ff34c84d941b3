"""Rule z: groups by the quadrant of their centre; what waits by bucket of near and far. Prints separation and plans."""
import numpy as np, sys
sys.path.insert(0,'/work/w/h4/docs/experiments/rules')
from rules import *
step=int(sys.argv[1]); mode=sys.argv[2]; caps=[int(v) for v in sys.argv[3].split(',')]
allr=[]
for n in sys.argv[4:]:
    s=Scene(n)
    c=np.fromfile(n+'.ctr',dtype=np.int32).reshape(-1,6)
    near,far=c[:,1]>>step,np.maximum(c[:,2],c[:,1])>>step
    nb=s.nb>>step
    prof={}
    for i in sorted(set(c[:,0])):
        m=c[:,0]==i
        if mode=='in': m&=c[:,5]==1
        d=np.zeros((4,nb+1)); np.add.at(d,(c[m,4],near[m]),c[m,3]); np.add.at(d,(c[m,4],far[m]+1),-c[m,3])
        prof[s.walks[i][0]]=d.cumsum(1)[:,:nb]
    z={w:p.sum(0).max() for w,p in prof.items()}
    for w in s.windows:
        i=s.get(w,'W'); allr.append((n.split('.')[0],w,s.peak['r'][i],z.get(w,0),s.peak['w'][i]))
    for cap in caps:
        plan={}
        for w,p in prof.items():
            if p.sum(0).max()<=cap or all(s.get(w,'F',x) is None for x in range(4)): continue
            two={'H':max((p[0]+p[1]).max(),(p[2]+p[3]).max()),'V':max((p[0]+p[2]).max(),(p[1]+p[3]).max())}
            v=min(two,key=two.get)
            plan[w]=[v+'0',v+'1'] if two[v]<=cap else ['F%d'%x for x in range(4) if s.get(w,'F',x) is not None]
        name='p_%s_z%s%d_%d'%(n.split('.')[0],mode,step,cap)
        write(plan,name)
        need={w for w in s.windows if s.peak['r'][s.get(w,'W')]>5632}
        print(name,'split',len(plan),'four',sum(1 for v in plan.values() if v[0][0]=='F'),'missed',sorted(need-set(plan)),'extra',sorted(set(plan)-need))
allr.sort(key=lambda t:-t[2])
th=min(t[3] for t in allr if t[2]>5632)
print('cap that catches all',th,'split',sum(t[3]>=th for t in allr),'needed',sum(t[2]>5632 for t in allr))
if '-v' in sys.argv: pass
for t in allr[:34]: print(t[0][:4],t[1],'r %d z %d w %d'%(t[2],t[3],t[4]))
