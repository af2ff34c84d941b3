import numpy as np, sys, re
sys.path.insert(0,'/work/w/h4/docs/experiments/rules')
from rules import *
exec(open('pw.py').read().split("scene,run,top")[0])
scene,run,pace,top=sys.argv[1],sys.argv[2],int(sys.argv[3]),int(sys.argv[4])
s=Scene(scene+'.3500')
d=np.fromfile(scene+'.3500.load',dtype=np.uint32).reshape(-1,256,16).astype(np.int64)
L=np.stack([d[:,lane==k].sum(1) for k in range(16)],1).max(1)
prev=0; out={}
for l in open(run+'.err'):
    if not l.startswith('walk'): continue
    m=re.match(r'walk \d+ window (\d+) (\w)(\d+) peak (-?\d+) done (-?\d+) last (-?\d+) end (-?\d+)',l)
    w,v,p,pk,dn,la,end=int(m[1]),m[2],int(m[3]),int(m[4]),int(m[5]),int(m[6]),int(m[7])
    o=out.setdefault(w,dict(v='',n=0,c=0,chunks=0,fetched=0,surv=0,rec=0,closed=0)); o['v']=v; o['n']+=1; o['c']+=end-prev; prev=end
    i=s.get(w,v,p); o['closed']+=dn>=0
    if i is None: continue
    o['chunks']+=s.count[i,1]; o['fetched']+=s.count[i,2]; o['surv']+=s.count[i,3]; o['rec']+=s.count[i,4]
sp=set(int(x) for x in re.findall(r'^spill .* window (\d+)',open(run+'.err').read(),re.M))
tot=sum(o['c'] for o in out.values()); acc=0
print(run,'total',tot,'windows',len(out))
print('| window | walks | cycles | share | RU | PU (survivors x %d / 4) | SU (records x 4.5 / 4) | fronts (Gaussians / 2) | walks that close early | spills |'%pace)
b={'RU':0,'PU':0,'SU':0,'fronts':0,'other':0}
for k,w in enumerate(sorted(out,key=lambda w:-out[w]['c'])):
    o=out[w]; acc+=o['c']
    B={'RU':int(L[w]),'PU':o['surv']*pace//4,'SU':int(o['rec']*4.5/4),'fronts':o['fetched']//2}
    if k<top: print('| %d | %d %s | %d | %.0f %% | %d | %d | %d | %d | %d | %s |'%(w,o['n'],o['v'],o['c'],100*acc/tot,*B.values(),o['closed'],'yes' if w in sp else ''))
for q in (5,10,15,20,30): print('top',q,'%.0f %%'%(100*sum(sorted((o['c'] for o in out.values()),reverse=True)[:q])/tot),end='; ')
print()
